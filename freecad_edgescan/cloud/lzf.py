# SPDX-License-Identifier: LGPL-2.1-or-later
"""Decompression of LZF, the compression inside binary_compressed .pcd files.

A stream of tokens. A first byte below 32 announces that many literal bytes plus one. Any other
repeats what was written before: its upper three bits are the length less 2 (7: one more length
byte follows), its lower five and the next byte the distance back less 1.
"""

from __future__ import annotations

__all__ = ["decompress_lzf"]


def decompress_lzf(data: bytes | bytearray, size: int) -> bytearray:
    """The ``size`` bytes that were compressed into ``data``.

    Raises
    ------
    ValueError: the stream is damaged or not of this size.
    """
    out = bytearray()
    place, end = 0, len(data)
    try:
        while place < end:
            token = data[place]
            place += 1
            if token < 32:
                out += data[place : place + token + 1]
                place += token + 1
                continue
            length = token >> 5
            if length == 7:
                length += data[place]
                place += 1
            length += 2
            distance = ((token & 31) << 8) + data[place] + 1
            place += 1
            start = len(out) - distance
            if start < 0:
                raise ValueError("The compressed data is damaged: it refers to before its start.")
            if distance >= length:
                out += out[start : start + length]
            else:
                pattern = out[start:]
                out += (pattern * (length // distance + 1))[:length]
    except IndexError:
        raise ValueError("The compressed data is damaged: it ends inside a token.") from None
    if len(out) != size:
        raise ValueError(
            f"The compressed data is damaged: it holds {len(out)} bytes instead of {size}."
        )
    return out
