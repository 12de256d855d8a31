# Sourced by try and release: an empty Debian in a folder, filled by debootstrap. It needs root and the network.

codenames=([12]=bookworm [13]=trixie)

mountedParts=(dev/pts dev proc)
unmount() {
    local part
    for part in "${mountedParts[@]}"; do
        if mountpoint -q "$1/$part"; then umount -l "$1/$part"; fi
    done
}

# emptyDebian RELEASE FOLDER: what was in FOLDER is deleted. Its first contents are kept in build/try, for the next time.
emptyDebian() {
    local codename=${codenames[$1]} machine=$2 base work
    base="$root/build/try/$codename.tar"
    mkdir -p "$root/build/try"
    if [ ! -e "$base" ]; then
        say "An empty Debian $1"
        work=$(mktemp -d)
        logged "$root/build/try/$codename.log" debootstrap --variant=minbase "$codename" "$work"
        tar -C "$work" -cf "$base.part" .
        mv "$base.part" "$base"
        rm -rf "$work"
    fi
    unmount "$machine"
    rm -rf "$machine"
    mkdir -p "$machine"
    tar -C "$machine" -xf "$base"
    cp /etc/resolv.conf "$machine/etc/"
    mkdir "$machine/trial"
}

# mountParts FOLDER: until unmount.
mountParts() {
    mount --bind /dev "$1/dev"
    mount --bind /dev/pts "$1/dev/pts"  # tests type into shells
    mount -t proc proc "$1/proc"
}

# within FOLDER COMMAND...: on that system, with nothing of this one's environment.
within() {
    chroot "$1" env -i PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin TERM=dumb \
        DEBIAN_FRONTEND=noninteractive HOME=/trial LANG=C.UTF-8 LIBGL_ALWAYS_SOFTWARE=1 "${@:2}"
}
