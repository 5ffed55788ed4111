# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a command knows and a scan does not, said after the scan's own reason of refusal."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

__all__ = ["told_besides"]


@contextmanager
def told_besides(*sentences: str) -> Iterator[None]:
    """Add sentences to what is refused within; "" is none.

    Raises
    ------
    ValueError: in place of the one that is raised within.
    """
    try:
        yield
    except ValueError as error:
        more = [sentence for sentence in sentences if sentence]
        if not more:
            raise
        raise ValueError(" ".join([str(error), *more])) from error
