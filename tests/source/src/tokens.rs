//! Tokens as the lexer of Rust joins them: `->` is one, a brace is one, a comment is none.

use proc_macro2::{Delimiter, Group, Spacing, Span, TokenStream, TokenTree};
use quote::ToTokens;

/// A token and where it stands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Token {
    /// Its text.
    pub text: String,
    /// Line of its first character, from 1.
    pub line: usize,
    /// Line of its last character.
    pub last_line: usize,
}

/// Operators of more than one character.
const OPERATORS: [&str; 24] = [
    "->", "=>", "::", "..", "..=", "...", "==", "!=", "<=", ">=", "&&", "||", "+=", "-=", "*=",
    "/=", "%=", "^=", "&=", "|=", "<<", ">>", "<<=", ">>=",
];

/// The tokens of a piece of syntax, without its comments.
pub fn tokens(syntax: &impl ToTokens) -> Vec<Token> {
    let mut lexer = Lexer::default();
    lexer.stream(syntax.to_token_stream());
    lexer.tokens
}

#[derive(Default)]
struct Lexer {
    tokens: Vec<Token>,
    /// The last token is punctuation that goes on without a space.
    joint: bool,
}

impl Lexer {
    fn stream(&mut self, stream: TokenStream) {
        for tree in stream {
            match tree {
                TokenTree::Group(group) if is_doc(&group) => self.forget_hash(),
                TokenTree::Group(group) => self.group(&group),
                TokenTree::Punct(punct) => {
                    self.operator(punct.as_char(), punct.span());
                    self.joint = punct.spacing() == Spacing::Joint;
                    continue;
                }
                // The quote of a lifetime is punctuation before a name.
                TokenTree::Ident(name) if self.joint && self.ends_with("'") => {
                    self.extend(&name.to_string());
                }
                other => self.push(other.to_string(), other.span()),
            }
            self.joint = false;
        }
    }

    fn group(&mut self, group: &Group) {
        let (open, close) = match group.delimiter() {
            Delimiter::Parenthesis => ("(", ")"),
            Delimiter::Brace => ("{", "}"),
            Delimiter::Bracket => ("[", "]"),
            Delimiter::None => return self.stream(group.stream()),
        };
        self.push(open.into(), group.span_open());
        self.joint = false;
        self.stream(group.stream());
        self.push(close.into(), group.span_close());
    }

    fn operator(&mut self, character: char, span: Span) {
        if self.joint
            && let Some(last) = self.tokens.last()
        {
            let longer = format!("{}{character}", last.text);
            if OPERATORS.contains(&longer.as_str()) {
                return self.extend(&character.to_string());
            }
        }
        self.push(character.into(), span);
    }

    fn push(&mut self, text: String, span: Span) {
        self.tokens.push(Token {
            text,
            line: span.start().line,
            last_line: span.end().line,
        });
    }

    fn extend(&mut self, text: &str) {
        if let Some(last) = self.tokens.last_mut() {
            last.text.push_str(text);
        }
    }

    fn ends_with(&self, text: &str) -> bool {
        self.tokens.last().is_some_and(|last| last.text == text)
    }

    /// Takes back the `#` or `#!` before an attribute.
    fn forget_hash(&mut self) {
        while self.ends_with("!") || self.ends_with("#") {
            self.tokens.pop();
        }
    }
}

/// `[doc = ".."]`, which a comment `/// ..` stands for.
fn is_doc(group: &Group) -> bool {
    if group.delimiter() != Delimiter::Bracket {
        return false;
    }
    let mut content = group.stream().into_iter();
    let is_named = matches!(content.next(), Some(TokenTree::Ident(name)) if name == "doc");
    is_named && matches!(content.next(), Some(TokenTree::Punct(sign)) if sign.as_char() == '=')
}

#[cfg(test)]
mod tests {
    use super::*;

    fn words(text: &str) -> String {
        let file = syn::parse_file(text).unwrap();
        let words: Vec<String> = tokens(&file).into_iter().map(|token| token.text).collect();
        words.join(" ")
    }

    #[test]
    fn operators_and_lifetimes_are_one_token() {
        assert_eq!(
            words("fn f<'a>(x: &'a u8) -> bool { x <= &1 || !(*x..=2).is_empty() }"),
            "fn f < 'a > ( x : & 'a u8 ) -> bool { x <= & 1 || ! ( * x ..= 2 ) . is_empty ( ) }"
        );
    }

    #[test]
    fn comments_are_no_tokens_and_lines_are_those_of_the_file() {
        let text = "//! A file.\n\n/// A thing.\n// why\nconst A: &str = \"a\nb\";\n";
        assert_eq!(words(text), "const A : & str = \"a\nb\" ;");
        let file = syn::parse_file(text).unwrap();
        let literal = &tokens(&file)[6];
        assert_eq!((literal.line, literal.last_line), (5, 6));
    }
}
