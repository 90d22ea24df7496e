# SPDX-License-Identifier: BSD-3-Clause
"""Promises of the shell scripts: README's commands exist, help and errors are clear, set-up is idempotent."""

import os
import subprocess
import sys
from pathlib import Path

import pytest
from conftest import ROOT

COMMANDS = ("run.sh", "test.sh")
SCRIPTS = ("install.sh", "paper.sh", "peers.sh", "scaling.sh", *COMMANDS)
NOBODY = "65534"


def run(*command: object, **more: object) -> subprocess.CompletedProcess[str]:
    return subprocess.run([str(word) for word in command], capture_output=True, text=True, **more)


def test_shellcheck_finds_nothing():
    checker = Path(sys.executable).with_name("shellcheck")
    files = [
        *(ROOT / "scripts").glob("*.sh"),
        *(ROOT / "tests" / "scripts").glob("*.sh"),
        ROOT / ".ci" / "run",
    ]
    result = run(checker, "-x", *files)
    assert result.returncode == 0, result.stdout


@pytest.mark.parametrize("name", COMMANDS)
def test_readme_names_a_command_that_exists(name):
    assert f"./scripts/{name}" in (ROOT / "README.md").read_text()
    assert os.access(ROOT / "scripts" / name, os.X_OK)


def test_ci_runs_the_second_command():
    assert "scripts/test.sh" in (ROOT / ".ci" / "run").read_text()
    assert os.access(ROOT / ".ci" / "run", os.X_OK)


@pytest.mark.parametrize("name", SCRIPTS)
def test_help_names_every_option(name, tmp_path):
    script = ROOT / "scripts" / name
    result = run(script, "--help", cwd=tmp_path)
    assert result.returncode == 0
    options = [
        word.split(")")[0]
        for word in script.read_text().split()
        if word.startswith("--") and word.endswith(")")
    ]
    assert options
    assert all(option in result.stdout for option in options)


@pytest.mark.parametrize("name", SCRIPTS)
def test_unknown_options_are_refused(name):
    result = run(ROOT / "scripts" / name, "--sideways")
    assert result.returncode != 0
    assert result.stderr.count("\n") == 1 and "--sideways" in result.stderr


@pytest.fixture
def machine(tmp_path):
    """Puts an apt-get that only notes its calls, and a dpkg-query that misses the given packages, on the path."""

    def make(*missing: str) -> dict[str, str]:
        tools = tmp_path / "tools"
        tools.mkdir()
        tmp_path.chmod(0o755)
        query = f'case " {" ".join(missing)} " in *" ${{@: -1}} "*) exit 1 ;; esac\nprintf installed\n'
        for name, body in (("dpkg-query", query), ("apt-get", f'echo "$@" >>{tmp_path}/apt-calls\n')):
            (tools / name).write_text(f"#!/bin/bash\n{body}")
            (tools / name).chmod(0o755)
        return {**os.environ, "PATH": f"{tools}:{os.environ['PATH']}"}

    return make


def test_nothing_is_installed_when_all_is_there(machine, tmp_path):
    result = run(ROOT / "scripts" / "install.sh", env=machine())
    assert result.returncode == 0, result.stderr
    assert not (tmp_path / "apt-calls").exists()


@pytest.mark.skipif(os.geteuid() != 0, reason="root alone installs without sudo")
def test_only_what_is_missing_is_installed(machine, tmp_path):
    result = run(ROOT / "scripts" / "install.sh", env=machine("libompl-dev", "libfcl-dev"))
    assert result.returncode == 0, result.stderr
    calls = (tmp_path / "apt-calls").read_text().splitlines()
    assert [call.split()[2:] for call in calls] == [
        ["update"],
        ["install", "--no-install-recommends", "libfcl-dev", "libompl-dev"],
    ]


def test_check_lists_what_is_missing_and_installs_nothing(machine, tmp_path):
    result = run(ROOT / "scripts" / "install.sh", "--check", env=machine("libompl-dev"))
    assert result.returncode == 1
    assert "Missing Debian packages: libompl-dev\n" in result.stdout
    assert not (tmp_path / "apt-calls").exists()


@pytest.mark.skipif(os.geteuid() != 0, reason="needs root to become somebody who may not install")
def test_without_the_right_to_install_the_missing_packages_are_named(machine, tmp_path):
    environment = machine("libompl-dev", "libfcl-dev")
    (tmp_path / "tools" / "sudo").write_text("#!/bin/bash\nexit 1\n")
    (tmp_path / "tools" / "sudo").chmod(0o755)
    for folder in tmp_path.parents:
        if folder != Path("/tmp") and Path("/tmp") in folder.parents:
            folder.chmod(0o755)
    as_nobody = ("setpriv", "--reuid", NOBODY, "--clear-groups")
    result = run(*as_nobody, ROOT / "scripts" / "install.sh", env=environment, stdin=subprocess.DEVNULL)
    assert result.returncode == 1
    assert "apt-get install libfcl-dev libompl-dev" in result.stderr
    assert not (tmp_path / "apt-calls").exists()
