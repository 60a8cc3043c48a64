"""Finds the commands in a Markdown file."""

from __future__ import annotations

import re

_COMMAND = re.compile(r"(?:[A-Z_]+=\S+ )?(?:\./evoloop|\./mvnw|java|prism) \S")
_FENCE = re.compile(r"^(`{3,}).*?^\1", re.MULTILINE | re.DOTALL)
_INLINE = re.compile(r"`([^`]+)`")


def commands(text: str) -> list[str]:
    """The commands in code blocks, joined to one line without comments, and those within sentences."""
    blocks = [line for fence in _FENCE.finditer(text) for line in fence.group().splitlines()]
    prose = _FENCE.sub("", text)
    blocks += [line[4:] for line in prose.splitlines() if line.startswith("    ")]
    lines = "\n".join(blocks).replace("\\\n", " ").splitlines()
    prose = "\n".join(line for line in prose.splitlines() if not line.startswith("    "))
    candidates = [re.sub(r"\s#\s.*", "", line) for line in lines] + _INLINE.findall(prose)
    tidy = (" ".join(candidate.split()) for candidate in candidates)
    return [command for command in tidy if _COMMAND.match(command)]
