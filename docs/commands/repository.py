"""A local Maven repository for tests: this project's modules, on top of what Maven has fetched for the project's build."""

from __future__ import annotations

import subprocess
from pathlib import Path

from test_commands import LIMIT_S, ROOT

SCAFFOLDED = ("bom", "program", "testkit")
"""The modules on which a scaffolded project depends."""


class Repository:
    def __init__(self, folder: Path) -> None:
        self.folder = folder

    def install(self, *modules: str) -> None:
        """Installs modules into it, with those that they need."""
        names = ",".join(f"framework/{module}" for module in modules)
        self.maven(ROOT / "pom.xml", "-q", "-Dmaven.test.skip=true", "-pl", names, "-am", "install")

    def maven(self, pom: Path, *arguments: str) -> str:
        """Runs Maven with it; returns Maven's output."""
        fetched = Path.home() / ".m2" / "repository"
        result = subprocess.run(
            [
                *(ROOT / "mvnw", "-B", "-f", pom, "--no-transfer-progress", *arguments),
                *(f"-Dmaven.repo.local={self.folder}", f"-Dmaven.repo.local.tail={fetched}"),
            ],
            cwd=pom.parent,
            capture_output=True,
            encoding="utf-8",
            timeout=LIMIT_S,
        )
        if result.returncode != 0:
            raise AssertionError(f"{pom}: {result.stdout[-3000:]}\n{result.stderr[-2000:]}")
        return result.stdout
