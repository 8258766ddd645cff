"""Reads a PNG as the editor writes it: red, green and blue of eight bits, not interlaced."""
import struct
import zlib

CHANNELS = 3


def paeth(left, above, corner):
    to_left, to_above, to_corner = abs(above - corner), abs(left - corner), abs(left + above - 2 * corner)
    if to_left <= to_above and to_left <= to_corner:
        return left
    return above if to_above <= to_corner else corner


def undo_filter(kind, row, above):
    """The row as it was before it was filtered (PNG specification, third edition, 9.2)."""
    for i in range(len(row)):
        left, corner = (row[i - CHANNELS], above[i - CHANNELS]) if i >= CHANNELS else (0, 0)
        prediction = (0, left, above[i], (left + above[i]) // 2, paeth(left, above[i], corner))[kind]
        row[i] = (row[i] + prediction) & 255
    return row


def pixels_of(file):
    """A function from a place, x and y, to red, green and blue."""
    with open(file, "rb") as stream:
        content = stream.read()
    at, data = 8, b""
    while at < len(content):
        length, kind = struct.unpack(">I4s", content[at:at + 8])
        body = content[at + 8:at + 8 + length]
        if kind == b"IHDR":
            width, height, depth, colours = struct.unpack(">IIBB", body[:10])
            assert (depth, colours) == (8, 2), "not red, green and blue of eight bits"
        elif kind == b"IDAT":
            data += body
        at += length + 12
    data, stride = zlib.decompress(data), 1 + CHANNELS * width
    rows = [bytes(stride - 1)]
    for y in range(height):
        line = data[y * stride:(y + 1) * stride]
        rows.append(undo_filter(line[0], bytearray(line[1:]), rows[-1]))
    return lambda x, y: tuple(rows[y + 1][CHANNELS * x:CHANNELS * x + CHANNELS])
