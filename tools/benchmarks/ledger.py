"""results/bench.json: what was measured so far, so that benchmarks can be run one by one."""
import json
import subprocess

from validation.program import ROOT

PATH = ROOT / "results/bench.json"


def load():
    """The ledger as it stands; empty where there is none, or one of an older form."""
    whole = json.loads(PATH.read_text(encoding="utf-8")) if PATH.is_file() else {}
    if not isinstance(whole.get("cases"), dict):
        whole = {"cases": {}}
    return whole


def save(whole):
    PATH.parent.mkdir(exist_ok=True)
    PATH.write_text(json.dumps(whole, indent=2) + "\n", encoding="utf-8")


def commit():
    """The commit of the sources beside the program, with + for changes; none outside a repository."""
    try:
        command = ["git", "describe", "--always", "--dirty=+", "--exclude=*"]
        said = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True)
    except (OSError, subprocess.CalledProcessError):
        return "none"
    return said.stdout.strip()
