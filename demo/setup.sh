# Installs or names the programs that a fresh machine lacks. Sourced by demo/run and tests/run; all text goes
# to stderr.
# shellcheck shell=sh

say() {
    printf 'pangaea: %s\n' "$*" >&2
}

# Cargo and a C compiler: without them nothing can be built.
need_compilers() {
    if ! command -v cargo >/dev/null 2>&1 && [ -x "${CARGO_HOME:-$HOME/.cargo}/bin/cargo" ]; then
        PATH="${CARGO_HOME:-$HOME/.cargo}/bin:$PATH"
        export PATH
    fi
    if ! command -v cargo >/dev/null 2>&1; then
        say "cargo is missing. Install Rust from https://rustup.rs:"
        say "    curl --proto '=https' --tlsv1.2 -sSf https://sh.rustup.rs | sh"
        exit 1
    fi
    if ! command -v cc >/dev/null 2>&1; then
        say "a C compiler is missing (cc); Rust links with it. Install one:"
        say "    Debian, Ubuntu:  apt-get install gcc libc6-dev"
        say "    Fedora:          dnf install gcc"
        say "    Arch:            pacman -S gcc"
        say "    macOS:           xcode-select --install"
        exit 1
    fi
}

is_linux() {
    [ "$(uname -s)" = Linux ]
}

# Whether the dynamic linker knows a library. Yes where it cannot be asked.
has_library() {
    cache=$(PATH="$PATH:/sbin:/usr/sbin" ldconfig -p 2>/dev/null) || return 0
    case $cache in
    *"$1 "*) return 0 ;;
    *) return 1 ;;
    esac
}

# Whether a Vulkan driver is installed, be it for a graphics card or lavapipe, which draws on the CPU.
has_driver() {
    if [ -n "${VK_DRIVER_FILES:-}${VK_ICD_FILENAMES:-}" ]; then
        return 0
    fi
    for manifest in /usr/share/vulkan/icd.d/*.json /usr/local/share/vulkan/icd.d/*.json /etc/vulkan/icd.d/*.json \
        /run/opengl-driver/share/vulkan/icd.d/*.json; do
        if [ -e "$manifest" ]; then
            return 0
        fi
    done
    return 1
}

has_vulkan() {
    has_library libvulkan.so.1 && has_driver
}

# What winit and egui open at run time, as pairs of library and Debian package.
WINDOW_LIBRARIES="libX11.so.6:libx11-6 libX11-xcb.so.1:libx11-xcb1 libXcursor.so.1:libxcursor1 libXi.so.6:libxi6
    libxkbcommon.so.0:libxkbcommon0 libxkbcommon-x11.so.0:libxkbcommon-x11-0"

# Packages that a window needs and that are not installed.
missing_window_packages() {
    for pair in $WINDOW_LIBRARIES; do
        has_library "${pair%%:*}" || printf ' %s' "${pair#*:}"
    done
}

# apt-get as root, by sudo where it asks for no password.
as_root() {
    if [ "$(id -u)" = 0 ]; then
        "$@"
    else
        sudo -n "$@"
    fi
}

may_install() {
    command -v apt-get >/dev/null 2>&1 || return 1
    [ "$(id -u)" = 0 ] || sudo -n true >/dev/null 2>&1
}

apt() {
    as_root env DEBIAN_FRONTEND=noninteractive apt-get -q "$@" </dev/null >&2
}

# Mesa 22 of Debian 12 crashes on some scenes and is slow; the backport is neither. The extra source is in a
# temporary file, so the machine's own list of sources stays as it is.
install_driver_from_backports() {
    grep -qs '^VERSION_CODENAME=bookworm' /etc/os-release || return 1
    sources=$(mktemp) || return 1
    {
        cat /etc/apt/sources.list 2>/dev/null || true
        echo "deb http://deb.debian.org/debian bookworm-backports main"
    } >"$sources"
    chmod 644 "$sources"
    installed=0
    apt -o "Dir::Etc::SourceList=$sources" update &&
        apt -o "Dir::Etc::SourceList=$sources" install -y --no-install-recommends -t bookworm-backports \
            mesa-vulkan-drivers libvulkan1 || installed=1
    rm -f "$sources"
    return $installed
}

# Installs packages where that is allowed, and says what is missing where it is not. Never fails: the program
# itself says why it cannot draw.
install_or_say() {
    packages=$*
    if ! may_install; then
        say "missing: $packages (names of Debian and Ubuntu). Install with:"
        say "    sudo apt-get install $packages"
        return 0
    fi
    say "installing $packages"
    case " $packages " in
    *" mesa-vulkan-drivers "*)
        if install_driver_from_backports; then
            packages=$(printf '%s' "$packages" | sed 's/mesa-vulkan-drivers//; s/libvulkan1//')
        fi
        ;;
    esac
    if [ -z "$(printf '%s' "$packages" | tr -d ' ')" ]; then
        return 0
    fi
    # shellcheck disable=SC2086 # a list of words
    apt update && apt install -y --no-install-recommends $packages ||
        say "could not install $packages"
}

# A Vulkan driver, for pictures.
need_driver() {
    if is_linux && ! has_vulkan; then
        install_or_say mesa-vulkan-drivers libvulkan1
    fi
}

# A Vulkan driver and the libraries of X11, for a window.
need_window() {
    need_driver
    if is_linux; then
        missing=$(missing_window_packages)
        if [ -n "$missing" ]; then
            # shellcheck disable=SC2086 # a list of words
            install_or_say $missing
        fi
    fi
}
