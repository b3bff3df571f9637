// Kinds of edges: their numbers.
