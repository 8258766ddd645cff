"""The states in which a loss of power may leave the files of a program.

`strace` records the calls of the program. What no completed fsync covers may be missing after a loss of power, in any
part: pages of a file, its length, and names in a folder (Pillai et al., "All File Systems Are Not Created Equal: On the
Complexity of Crafting Crash-Consistent Applications", OSDI 2014).
"""
import ast
import collections
import os
import re
import time

PAGE = 4096
CALLS = ("openat,write,lseek,ftruncate,rename,renameat,renameat2,link,linkat,unlink,unlinkat,mkdir,fsync,"
         "fdatasync,close,exit_group")
TEXT = re.compile(r'"((?:\\x[0-9a-f]{2})*)"')

Call = collections.namedtuple("Call", "process begins name texts numbers flags result")


def traced(log, *command):
    """The command with its calls recorded in `log`. Its process is that of the program."""
    return ["strace", "-D", "-f", "-qqq", "-xx", "-s", str(1 << 28), "-e", "signal=none", "-e", "trace=" + CALLS,
            "-o", log, *command]


def wait_for_end(log):
    """Waits until a program that was ended with status 0 or killed is recorded whole."""
    size = -1
    while size != (size := os.path.getsize(log)):
        time.sleep(0.3)


def calls(log):
    """Yields the calls. One that waits is yielded at its beginning, without a result, and again at its end."""
    waiting = {}
    with open(log, encoding="ascii") as file:
        for line in file:
            process, _, text = line.strip().partition(" ")
            text = text.lstrip()
            if text.startswith("<... "):
                text = waiting.pop(process) + text.partition("resumed>")[2]
            begins = text.endswith("<unfinished ...>")
            if begins:
                text = waiting[process] = text[:-len("<unfinished ...>")]
            name, _, arguments = text.partition("(")
            if not name.isidentifier():
                continue
            texts = [ast.literal_eval(f'b"{found}"') for found in TEXT.findall(arguments)]
            arguments = TEXT.sub('""', arguments)
            result = re.search(r"\) += (-?\d+)", arguments)
            arguments = arguments[:result.start()] if result else arguments
            flags = set(re.findall(r"\b[A-Z][A-Z_]+\b", arguments))
            numbers = [int(n) for n in re.findall(r"(?<![\w])-?\d+", arguments)]
            yield Call(process, begins, name, texts, numbers, flags, int(result[1]) if result else None)


class Inode:
    """A file or a folder: its state on the disk, and the later changes, which the disk may lack."""

    def __init__(self, bytes_on_disk=b""):
        self.on_disk, self.now, self.pending, self.synced = bytes_on_disk, bytearray(bytes_on_disk), [], 0

    def change(self, at, data):
        """Writes data; None ends the file there."""
        self.pending.append((at, data))
        self.now = bytearray(changed(self.now, at, data))

    def sync(self, changes):
        """Puts the first changes since the program began on the disk."""
        while self.synced < changes:
            self.on_disk = changed(self.on_disk, *self.pending.pop(0))
            self.synced += 1

    def after_loss(self, chance):
        content = bytes(self.on_disk)
        for at, data in self.pending:
            if chance.random() < 0.3:
                continue
            if data is None:
                content = changed(content, at, None)
                continue
            whole = chance.random() < 0.5
            for start in range(0, len(data), PAGE):
                if whole or chance.random() < 0.5:
                    content = changed(content, at + start, data[start:start + PAGE])
        return content


def changed(content, at, data):
    if data is None:
        return content[:at] + bytes(max(0, at - len(content)))
    return bytes(content[:at]) + bytes(max(0, at - len(content))) + data + bytes(content[at + len(data):])


class Disk:
    """The files of a folder while a recorded program runs. The files that were there before, {path: bytes}, are on the
    disk."""

    def __init__(self, folder, before):
        self.folder = os.path.realpath(folder)
        self.names = {path: Inode(content) for path, content in before.items()}
        self.on_disk, self.pending, self.synced = dict(self.names), collections.defaultdict(list), {}
        self.open, self.began = {}, {}  # (inode or folder, position) by descriptor; changes at the begin of an fsync

    def path(self, text):
        path = os.path.join(self.folder, os.fsdecode(text))
        return path if path.startswith(self.folder) else None

    def set_names(self, *names):
        """Changes the inodes of paths, (path, inode or None), at once."""
        apply(self.names, names)
        self.pending[os.path.dirname(names[-1][0])].append(names)

    def take(self, call):
        """Follows one call."""
        if call.name in ("fsync", "fdatasync"):
            return self.flush(call)
        if call.begins or call.result is None or call.result < 0:
            return None
        return getattr(self, "take_" + call.name)(call)

    def take_nothing(self, _):
        pass

    take_mkdir = take_exit_group = take_nothing  # of a folder, the files in it are followed

    def take_openat(self, call):
        path = self.path(call.texts[0])
        self.open.pop(call.result, None)
        if path is None:
            return
        if "O_TMPFILE" in call.flags:
            self.open[call.result] = [Inode(), 0, False]
        elif "O_DIRECTORY" in call.flags:
            self.open[call.result] = [path, 0, False]
        elif call.flags & {"O_WRONLY", "O_RDWR"}:
            if path not in self.names:
                self.set_names((path, Inode()))
            if "O_TRUNC" in call.flags:
                self.names[path].change(0, None)
            self.open[call.result] = [self.names[path], 0, "O_APPEND" in call.flags]

    def take_write(self, call):
        file = self.open.get(call.numbers[0])
        if file is None:
            return
        inode, position, appends = file
        at = len(inode.now) if appends else position
        inode.change(at, call.texts[0][:call.result])
        file[1] = at + call.result

    def take_lseek(self, call):
        if call.numbers[0] in self.open:
            self.open[call.numbers[0]][1] = call.result

    def take_ftruncate(self, call):
        if call.numbers[0] in self.open:
            self.open[call.numbers[0]][0].change(call.numbers[1], None)

    def take_close(self, call):
        self.open.pop(call.numbers[0], None)

    def take_rename(self, call):
        old, new = (self.path(text) for text in call.texts)
        if new is not None and old in self.names:
            self.set_names((old, None), (new, self.names[old]))

    take_renameat = take_renameat2 = take_rename

    def take_link(self, call):
        old, new = call.texts
        descriptor = re.fullmatch(rb"/proc/self/fd/(\d+)", old)
        inode = self.open[int(descriptor[1])][0] if descriptor else self.names.get(self.path(old))
        if self.path(new) is not None:
            self.set_names((self.path(new), inode))

    take_linkat = take_link

    def take_unlink(self, call):
        path = self.path(call.texts[0])
        if path in self.names:
            self.set_names((path, None))

    take_unlinkat = take_unlink

    def flush(self, call):
        what = self.open.get(call.numbers[0], [None])[0]
        if isinstance(what, Inode):
            count = what.synced + len(what.pending)
        elif what is not None:
            count = len(self.pending[what])
        else:
            return
        if call.begins:
            self.began[call.process] = count
            return
        count = self.began.pop(call.process, count)
        if isinstance(what, Inode):
            what.sync(count)
            return
        for names in self.pending[what][self.synced.get(what, 0):count]:
            apply(self.on_disk, names)
        self.synced[what] = max(count, self.synced.get(what, 0))

    def after_loss(self, chance):
        """{path: bytes} as a loss of power may leave it."""
        names = dict(self.on_disk)
        for folder, changes in self.pending.items():
            left = changes[self.synced.get(folder, 0):]
            kept = left[:chance.randint(0, len(left))] if chance.random() < 0.5 else [
                change for change in left if chance.random() < 0.5]
            for change in kept:
                apply(names, change)
        return {path: inode.after_loss(chance) for path, inode in sorted(names.items())}


def apply(names, changes):
    for path, inode in changes:
        names.pop(path, None)
        if inode is not None:
            names[path] = inode
