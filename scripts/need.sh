# Installs programs that a script needs and this machine lacks. Read by the other scripts.

as_root() {
    if [ "$(id -u)" = 0 ]; then "$@"; else sudo "$@"; fi
}

install() {
    as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -q "$1" >/dev/null
}

# Debian's package that has a program, if the program is missing.
need() {
    command -v "$1" >/dev/null && return
    if ! command -v apt-get >/dev/null; then
        echo "error: planform's scripts need \`$1\`; install $2 and run this again" >&2
        exit 1
    fi
    echo "installing $2 for \`$1\`"
    install "$2" || { as_root apt-get update -q >/dev/null && install "$2"; }
}
