"""Reads the arrays of the program's VTP files (docs/formats.md) with nothing but the standard library."""
import array
import re
import struct
import zlib

TYPES = {"Float64": "d", "Int64": "q"}
TAG = re.compile(rb"<DataArray ([^>]*)/?>")
ATTRIBUTE = re.compile(rb'(\w+)="([^"]*)"')


def inflate(data, start):
    """The bytes of one compressed array: block count, block size, last block's size, sizes, blocks."""
    blocks, = struct.unpack_from("<Q", data, start)
    sizes = struct.unpack_from(f"<{blocks}Q", data, start + 24)
    at, parts = start + 24 + 8 * blocks, []
    for size in sizes:
        parts.append(zlib.decompress(data[at:at + size]))
        at += size
    return b"".join(parts)


def read_vtp(path):
    """All named arrays as name -> list of numbers, or of tuples where an entry has three."""
    data = path.read_bytes()
    marker = data.index(b"<AppendedData")
    start = data.index(b"_", data.index(b">", marker)) + 1
    arrays = {}
    for tag in TAG.finditer(data, 0, marker):
        fields = {key.decode(): value.decode() for key, value in ATTRIBUTE.findall(tag.group(1))}
        if "offset" not in fields or fields.get("type") not in TYPES:
            continue
        values = array.array(TYPES[fields["type"]])
        values.frombytes(inflate(data, start + int(fields["offset"])))
        if fields.get("NumberOfComponents", "1") == "3":
            values = list(zip(values[0::3], values[1::3], values[2::3]))
        arrays[fields.get("Name", "Points")] = list(values)
    return arrays
