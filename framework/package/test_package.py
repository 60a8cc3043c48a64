"""The contents of the Debian package, and its behaviour in Debian systems: installed, run, upgraded, rolled back,
removed and purged; its service upgraded, killed, frozen, stopped and removed.

Run by ./evoloop test --package, which has built the package and the Debian systems that EVOLOOP_ROOTS names.
"""

from __future__ import annotations

import hashlib
import io
import os
import re
import shlex
import shutil
import subprocess
import tarfile
import tempfile
import time
import unittest
from collections.abc import Callable
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[2]
PACKAGE = next((PROJECT / "target").glob("evoloop_*_all.deb"))
ROOTS = [Path(root) for root in os.environ.get("EVOLOOP_ROOTS", "").split()]
PROGRAMS = {"./usr/bin/evoloop", "./usr/lib/evoloop/make-safe", "./usr/lib/evoloop/prepare-classes"}
# Those of this computer's processor architecture; systemd can boot only there.
OWN_ROOTS = [root for root in ROOTS if "-" not in root.name]
LIMIT_S = 600


def members(package: Path) -> dict[str, bytes]:
    """The members of the ar archive, in order."""
    data = package.read_bytes()
    assert data.startswith(b"!<arch>\n")
    found, at = {}, 8
    while at < len(data):
        name, size = data[at : at + 16].decode().strip().rstrip("/"), int(data[at + 48 : at + 58])
        found[name] = data[at + 60 : at + 60 + size]
        at += 60 + size + size % 2
    return found


def tar(member: bytes) -> tarfile.TarFile:
    return tarfile.open(fileobj=io.BytesIO(member))


class ContentTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls) -> None:
        cls.members = members(PACKAGE)
        cls.control = tar(cls.members["control.tar.gz"])
        cls.data = tar(cls.members["data.tar.gz"])

    def control_file(self, name: str) -> str:
        member = next(member for member in self.control if member.name.lstrip("./") == name)
        return self.control.extractfile(member).read().decode()  # type: ignore[union-attr]

    def test_it_is_a_debian_package_for_every_architecture(self) -> None:
        self.assertEqual(list(self.members), ["debian-binary", "control.tar.gz", "data.tar.gz"])
        self.assertEqual(self.members["debian-binary"], b"2.0\n")
        control = self.control_file("control")
        for line in ("Package: evoloop", "Architecture: all"):
            self.assertIn(line, control)
        self.assertRegex(control, "(?m)^Depends: default-jre-headless")

    def test_every_file_is_roots_and_may_be_read_and_no_more(self) -> None:
        for member in self.data:
            with self.subTest(file=member.name):
                self.assertEqual((member.uname, member.gname, member.uid, member.gid), ("root", "root", 0, 0))
                mode = 0o755 if member.isdir() or member.name in PROGRAMS else 0o644
                self.assertEqual(oct(member.mode), oct(mode))

    def test_the_configuration_is_the_administrators(self) -> None:
        self.assertEqual(
            sorted(self.control_file("conffiles").split()), ["/etc/evoloop/lamp.yaml", "/etc/evoloop/roomba.yaml"]
        )

    def test_every_file_has_its_checksum(self) -> None:
        sums = dict(reversed(line.split(maxsplit=1)) for line in self.control_file("md5sums").splitlines())
        files = {member.name.lstrip("./"): member for member in self.data if member.isfile()}
        self.assertEqual(set(files) - {name for name in files if name.startswith("etc/")} - set(sums), set())
        for name, known in sums.items():
            data = self.data.extractfile(files[name]).read()  # type: ignore[union-attr]
            self.assertEqual(hashlib.md5(data, usedforsecurity=False).hexdigest(), known, name)

    def test_two_builds_are_equal(self) -> None:
        first = PACKAGE.read_bytes()
        subprocess.run([PROJECT / "framework/package/build"], check=True)
        self.assertTrue(first == PACKAGE.read_bytes(), "the package differs from one build to the next")


class PreparedTest(unittest.TestCase):
    """Which form of preparation the JVM gets, with one that only says its version."""

    JAVA = """#!/bin/sh
    case "$*" in *-version*) echo 'openjdk version "VERSION" 2026-01-01' >&2; exit ;; esac
    for each; do case "$each" in -XX:AOTCacheOutput=* | -XX:SharedArchiveFile=*) echo x >"${each#*=}" ;; esac; done
    """

    def prepared(self, version: str) -> list[str]:
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            scripts = PROJECT / "framework/package/root/usr/lib/evoloop"
            for script in ("common", "prepare-classes"):
                text = (scripts / script).read_text().replace("/var/cache/evoloop", name)
                (folder / script).write_text(text.replace("/usr/lib/evoloop", name))
            java = folder / "java"
            java.write_text(self.JAVA.replace("VERSION", version))
            java.chmod(0o755)
            subprocess.run(["sh", folder / "prepare-classes"], check=True, env={"PATH": f"{name}:/usr/bin:/bin"})
            return sorted(path.name for path in folder.iterdir() if path.name.startswith("evoloop-models"))

    def test_a_jvm_of_25_or_newer_gets_an_aot_cache_and_an_older_one_an_archive(self) -> None:
        for version in ("25", "25.0.3", "26-ea"):
            self.assertEqual(self.prepared(version), ["evoloop-models.aot"], version)
        for version in ("17.0.15", "21.0.2", "24"):
            self.assertEqual(self.prepared(version), ["evoloop-models.jsa"], version)


@unittest.skipUnless(ROOTS, "the Debians are made by ./evoloop test --package, which needs root and debootstrap")
class DebianTest(unittest.TestCase):
    def setUp(self) -> None:
        for root in ROOTS:
            shutil.copy(PACKAGE, root / "tmp/evoloop.deb")
            subprocess.run(["mount", "--bind", "/dev", root / "dev"], check=True)
            self.addCleanup(subprocess.run, ["umount", "-l", root / "dev"])
            subprocess.run(["mount", "-t", "devpts", "-o", "newinstance,ptmxmode=0666,mode=0620", "devpts", root / "dev/pts"])
            self.addCleanup(subprocess.run, ["umount", "-l", root / "dev/pts"])
            subprocess.run(["mount", "-t", "proc", "proc", root / "proc"], check=True)
            self.addCleanup(subprocess.run, ["umount", "-l", root / "proc"])

    def do(self, root: Path, command: str, status: int = 0, given: str = "") -> str:
        result = subprocess.run(
            ["chroot", root, "sh", "-c", command],
            input=given,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            timeout=LIMIT_S,
            env={"PATH": "/usr/sbin:/usr/bin:/sbin:/bin", "LC_ALL": "C.UTF-8", "DEBIAN_FRONTEND": "noninteractive"},
        )
        self.assertEqual(result.returncode, status, f"{root.name}: {command}\n{result.stdout}")
        return result.stdout

    def test_the_whole_life_of_a_package(self) -> None:
        for root in ROOTS:
            with self.subTest(release=root.name):
                self.do(root, "dpkg --purge evoloop")
                self.install(root)
                self.run_the_service(root)
                self.change_versions(root)
                self.remove(root)

    def install(self, root: Path) -> None:
        self.do(root, "groupadd --force --system gpio && dpkg -i /tmp/evoloop.deb")
        groups = self.do(root, "id -nG evoloop").split()
        self.assertLessEqual({"evoloop", "dialout", "video", "gpio"}, set(groups))
        archive = self.do(root, "stat -c %U:%s /var/cache/evoloop/roomba-converter.jsa").strip()
        self.assertRegex(archive, r"^evoloop:\d{8}$")
        self.assertIn("usage: evoloop", self.do(root, "evoloop help"))
        self.assertIn("EVOLOOP(1)", self.do(root, "man -P cat evoloop | head -1"))
        self.do(root, "man -P cat 5 evoloop.yaml")
        self.assertEqual(self.completed(root, "evoloop", "sim"), ["simulator"])
        self.assertEqual(self.completed(root, "evoloop", "roomba", "--sim"), ["--simulate"])
        self.assertEqual(self.completed(root, "evoloop", "run", ""), ["lamp", "roomba"])
        self.assertIn("search-limit", self.do(root, "evoloop roomba --config /etc/evoloop/roomba.yaml --print-config"))
        self.assertIn("/tmp/é", self.do(root, "env -u LC_ALL evoloop lightbulb --journal /tmp/é --print-config"))
        self.assertIn("names no program", self.do(root, "echo 'x: y' > /etc/evoloop/x.yaml; evoloop run x", status=2))
        self.do(root, "rm /etc/evoloop/x.yaml")
        self.run_a_device_file(root)
        self.do(root, "systemd-analyze verify evoloop@roomba.service")
        score = self.do(root, "systemd-analyze security --offline=yes evoloop@roomba.service | tail -1")
        self.assertLess(float(re.search(r"level for \S+: ([\d.]+)", score).group(1)), 3)  # type: ignore[union-attr]
        if root in OWN_ROOTS:
            # It examines only the package, slowly on an emulated processor.
            self.assertEqual(self.do(root, "lintian --allow-root --fail-on error,warning /tmp/evoloop.deb"), "")

    def run_a_device_file(self, root: Path) -> None:
        bulb = "/usr/share/evoloop/devices/light-bulb"
        self.assertIn("passed: switched twice", self.do(root, f"evoloop check {bulb}/light-bulb.yaml"))
        self.do(root, "evoloop check /usr/share/evoloop/devices/roomba/roomba.yaml")
        self.do(root, f"cp {bulb}/README.md /etc/evoloop/ && cp {bulb}/light-bulb.yaml /etc/evoloop/bulb.yaml")
        said = self.do(root, "evoloop run bulb --simulate", given="press switch\nhistory\nexit\n")
        self.assertNotIn("error", said)
        self.do(root, "rm /etc/evoloop/bulb.yaml /etc/evoloop/README.md")

    def completed(self, root: Path, *words: str) -> list[str]:
        """What bash completes the last word to."""
        script = (
            ". /usr/share/bash-completion/completions/evoloop; "
            'COMP_WORDS=("$@") COMP_CWORD=$(($# - 1)); _evoloop "$1" "${@: -1}" "${@: -2:1}"; printf "%s\\n" "${COMPREPLY[@]}"'
        )
        return self.do(root, shlex.join(["bash", "-c", script, "bash", *words])).split()

    def run_the_service(self, root: Path) -> None:
        """The unit's command line, as its user and in its directories."""
        state = "/var/lib/evoloop/roomba"
        self.do(root, f"install -d -o evoloop -g evoloop -m 700 {state} /run/evoloop")
        command = (
            f"cd /var/lib/evoloop && RUNTIME_DIRECTORY=/run/evoloop STATE_DIRECTORY={state} "
            "exec setpriv --reuid=evoloop --regid=evoloop --init-groups evoloop run roomba --simulate"
        )
        service = subprocess.Popen(
            ["chroot", root, "sh", "-c", command],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            env={"PATH": "/usr/sbin:/usr/bin:/sbin:/bin", "LC_ALL": "C.UTF-8"},
        )
        try:
            self.await_instance(root, service)
            self.assertIn("roomba, running", self.do(root, "evoloop ctl roomba status"))
            self.do(root, "evoloop ctl roomba press clean")
            self.do(root, f"test -n \"$(ls {state})\"")
            self.do(root, "evoloop ctl roomba exit")
        finally:
            service.terminate()
            output = service.communicate(timeout=LIMIT_S)[0]
        self.assertEqual(service.returncode, 0, output)
        self.do(root, "/usr/lib/evoloop/make-safe /etc/evoloop/roomba.yaml")
        self.assertEqual(self.do(root, "evoloop lightbulb", given="start\nswitch\nexit\n").count("switch command"), 1)

    def await_instance(self, root: Path, service: subprocess.Popen[str]) -> None:
        end = time.monotonic() + LIMIT_S
        while "roomba" not in self.do(root, "evoloop ctl 2>&1 || true"):
            self.assertIsNone(service.poll(), "the service has ended")
            self.assertLess(time.monotonic(), end, "nobody listens")

    def change_versions(self, root: Path) -> None:
        """An upgrade keeps the administrator's changes, and can be rolled back."""
        self.do(root, "sed -i 's/^port:.*/port: \\/dev\\/ttyUSB7/' /etc/evoloop/roomba.yaml")
        self.do(
            root,
            "rm -rf /tmp/next && dpkg-deb -R /tmp/evoloop.deb /tmp/next && "
            "sed -i 's/^Version:.*/Version: 99.0/' /tmp/next/DEBIAN/control && dpkg-deb -Zgzip -b /tmp/next /tmp/next.deb",
        )
        for package, version in (("next", "99.0"), ("evoloop", "")):
            self.do(root, f"dpkg -i /tmp/{package}.deb")
            self.assertIn(version, self.do(root, "dpkg-query -W -f '${Version}' evoloop"))
            self.assertIn("ttyUSB7", self.do(root, "cat /etc/evoloop/roomba.yaml"))
            self.assertIn("ttyUSB7", self.do(root, "evoloop roomba --config /etc/evoloop/roomba.yaml --print-config"))
            self.do(root, "test -s /var/cache/evoloop/roomba-converter.jsa")
        self.do(root, "rm /var/cache/evoloop/*.jsa && dpkg-trigger --no-await /usr/lib/jvm && dpkg --configure --pending")
        self.do(root, "test -s /var/cache/evoloop/roomba-converter.jsa")

    def remove(self, root: Path) -> None:
        self.do(root, "dpkg --remove evoloop")
        self.do(root, "test ! -e /var/cache/evoloop && test ! -e /usr/bin/evoloop && test ! -e /usr/share/evoloop")
        self.do(root, "test -e /etc/evoloop/roomba.yaml && test -e /var/lib/evoloop/roomba")
        self.do(root, "dpkg --purge evoloop")
        self.do(root, "test ! -e /etc/evoloop && test ! -e /var/lib/evoloop && ! getent passwd evoloop")


@unittest.skipUnless(OWN_ROOTS, "the Debians are made by ./evoloop test --package, which needs root and debootstrap")
class BootTest(unittest.TestCase):
    """The service under a systemd that has booted in one of the Debian systems."""

    def boot(self, root: Path) -> None:
        command = ["systemd-nspawn", "--quiet", "--boot", "--register=no", "--keep-unit", "-M", "evoloop-test", "-D", root]
        # The console's login needs its own terminal.
        machine = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.addCleanup(machine.wait)
        self.await_that(lambda: self.leader(machine) != "" or machine.poll() is not None)
        leader = self.leader(machine)
        # Everything in it ends with its first process, which does not end with the command.
        self.addCleanup(subprocess.run, ["kill", "-KILL", leader])
        self.inside = ["nsenter", "-t", leader, "-a"]
        self.await_that(lambda: self.do("systemctl is-system-running || true") in ("running", "degraded"))

    @staticmethod
    def leader(machine: subprocess.Popen[bytes]) -> str:
        return subprocess.run(["pgrep", "-P", str(machine.pid)], capture_output=True, text=True).stdout.strip()

    def do(self, command: str) -> str:
        result = subprocess.run(
            [*self.inside, "sh", "-c", command],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            timeout=LIMIT_S,
        )
        self.assertEqual(result.returncode, 0, f"{command}\n{result.stdout}")
        return result.stdout.strip()

    def await_that(self, holds: Callable[[], bool]) -> None:
        end = time.monotonic() + LIMIT_S
        while not holds():
            self.assertLess(time.monotonic(), end, "it never came about")
            time.sleep(0.5)

    def of(self, unit_property: str) -> str:
        return self.do(f"systemctl show -p {unit_property} --value evoloop@roomba")

    def await_another(self, process: str) -> None:
        def is_there() -> bool:
            # One question, since the process may end between two.
            shown = self.do("systemctl show -p ActiveState -p MainPID evoloop@roomba").split()
            return "ActiveState=active" in shown and f"MainPID={process}" not in shown

        self.await_that(is_there)

    def wait_for_a_robot(self) -> None:
        """The robot's port is not there yet, which the service says once, as a warning."""
        self.do("systemctl start evoloop@roomba")
        self.assertEqual(self.of("ActiveState"), "active")
        warnings = self.do("journalctl -b -u evoloop@roomba -p warning -o cat")
        self.assertEqual(warnings.count("/dev/ttyUSB0"), 1, warnings)
        self.do("systemctl stop evoloop@roomba")

    def stop_it_while_it_starts(self) -> None:
        self.do("systemctl start --no-block evoloop@roomba")
        self.await_that(lambda: self.of("MainPID") != "0")
        self.do("systemctl stop evoloop@roomba")
        self.assertEqual(self.of("Result"), "success")

    def test_it_waits_is_upgraded_killed_frozen_stopped_and_removed(self) -> None:
        for root in OWN_ROOTS:
            with self.subTest(release=root.name):
                shutil.copy(PACKAGE, root / "root/evoloop.deb")
                self.boot(root)
                self.do("dpkg --purge evoloop; groupadd --force --system gpio; dpkg -i /root/evoloop.deb")
                self.wait_for_a_robot()
                self.stop_it_while_it_starts()
                self.do("sed -i 's/^port:.*/simulate: true/' /etc/evoloop/roomba.yaml")
                self.do("mkdir -p /run/systemd/system/evoloop@.service.d")
                self.do("printf '[Service]\\nWatchdogSec=10\\n' > /run/systemd/system/evoloop@.service.d/test.conf")
                self.do("systemctl daemon-reload && systemctl start evoloop@roomba")
                self.do("evoloop ctl roomba press clean")
                self.await_that(lambda: "original On, new On" in self.do("evoloop ctl roomba status"))
                upgraded = self.of("MainPID")
                self.do("dpkg -i /root/evoloop.deb")
                self.await_another(upgraded)
                killed = self.of("MainPID")
                self.do(f"kill -KILL {killed}")
                self.await_another(killed)
                self.assertIn("Clean", self.do("evoloop ctl roomba history"), "the press before the kill is forgotten")
                frozen = self.of("MainPID")
                self.do(f"kill -STOP {frozen}")
                self.await_another(frozen)
                self.assertIn("Watchdog timeout", self.do("journalctl -b -u evoloop@roomba"))
                self.do("systemctl stop evoloop@roomba")
                self.assertEqual((self.of("Result"), self.of("ExecMainStatus")), ("success", "0"))
                self.do("systemctl start evoloop@roomba")
                self.do("dpkg --purge evoloop")
                self.assertEqual(self.do("systemctl is-active evoloop@roomba || true"), "inactive")
                self.doCleanups()


if __name__ == "__main__":
    unittest.main()
