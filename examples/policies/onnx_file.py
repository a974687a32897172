# SPDX-License-Identifier: BSD-3-Clause
"""Writes ONNX files by the wire format of protobuf, without other packages than NumPy."""

import struct

FLOAT, INT64 = 1, 7


def varint(value):
    value &= (1 << 64) - 1
    out = bytearray()
    while value >= 0x80:
        out.append(0x80 | (value & 0x7F))
        value >>= 7
    out.append(value)
    return bytes(out)


def whole(number, value):
    return varint(number << 3) + varint(value)


def data(number, value):
    value = value.encode() if isinstance(value, str) else value
    return varint(number << 3 | 2) + varint(len(value)) + value


def single(number, value):
    return varint(number << 3 | 5) + struct.pack("<f", value)


def tensor(name, array):
    """A constant from an array of float32 or int64."""
    kind = INT64 if array.dtype.kind == "i" else FLOAT
    raw = array.astype("<i8" if kind == INT64 else "<f4").tobytes()
    return b"".join(whole(1, size) for size in array.shape) + whole(2, kind) + data(8, name) + data(9, raw)


def attribute(name, value):
    if isinstance(value, float):
        return data(1, name) + single(2, value)
    if isinstance(value, int):
        return data(1, name) + whole(3, value)
    return data(1, name) + b"".join(whole(8, one) for one in value)


def node(op, inputs, outputs, **attributes):
    text = b"".join(data(1, name) for name in inputs) + b"".join(data(2, name) for name in outputs)
    text += data(3, op + "_of_" + outputs[0]) + data(4, op)
    return text + b"".join(data(5, attribute(name, value)) for name, value in attributes.items())


def port(name, shape):
    sizes = b"".join(data(1, whole(1, size)) for size in shape)
    return data(1, name) + data(2, data(1, whole(1, FLOAT) + data(2, sizes)))


def model(nodes, constants, inputs, outputs, notes=None):
    """The bytes of a file with input "obs" and output "action"."""
    graph = b"".join(data(1, one) for one in nodes)
    graph += b"".join(data(5, tensor(name, array)) for name, array in constants.items())
    graph += data(11, port("obs", (1, inputs))) + data(12, port("action", (1, outputs)))
    text = whole(1, 8) + data(7, graph) + data(8, data(1, "") + whole(2, 17))
    for key, value in (notes or {}).items():
        text += data(14, data(1, key) + data(2, value))
    return text
