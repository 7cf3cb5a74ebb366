"""What the validation scripts that run whole suspensions share: running a case once, means over seeds, tables."""
import json
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent


def plotting():
    """pyplot that writes files. Asked for before the runs: without it the script ends at once and says what to do."""
    try:
        import matplotlib
    except ModuleNotFoundError as missing:
        sys.exit(f"{missing}\n  fix: apt-get install python3-matplotlib python3-numpy")
    matplotlib.use("Agg")
    import matplotlib.pyplot
    return matplotlib.pyplot


def run(binary, case, output, settings):
    """Summary of one run; taken from `output` where it has finished before, gone on with where it was interrupted. Ends
    where `output` holds a run of other settings."""
    summary, asked = output / "summary.json", output / "asked.json"
    if asked.exists() and (before := json.loads(asked.read_text())) != settings:
        other = ", ".join(f"{key}: {before.get(key)} there, {settings.get(key)} asked"
                          for key in sorted({*before, *settings}) if before.get(key) != settings.get(key))
        sys.exit(f"{output} holds a run of other settings ({other})\n  fix: another --output, or remove the folder")
    if summary.exists() and json.loads(summary.read_text())["status"] != "interrupted":
        return json.loads(summary.read_text())
    if (output / "results.h5").exists():
        command = [binary, "restart", output, "--quiet"]
    else:
        output.mkdir(parents=True, exist_ok=True)
        asked.write_text(json.dumps(settings, indent=1) + "\n")
        command = [binary, "run", ROOT / case, "--output", output, "--force", "--quiet"]
        for key, value in settings.items():
            command += ["--set", f"{key}={json.dumps(value)}"]
    if code := subprocess.run(command, stdout=subprocess.DEVNULL).returncode:
        sys.exit(f"{output}: the run ended with exit code {code}")
    return json.loads(summary.read_text())


def combine(summaries, pick):
    """Mean over independent seeds; its error from the runs' own error bars and from their scatter, the larger."""
    means = [pick(s)["mean"] for s in summaries]
    errors = [pick(s)["error"] for s in summaries]
    n = len(means)
    mean = sum(means) / n
    within = sum(e * e for e in errors) ** 0.5 / n
    between = (sum((m - mean) ** 2 for m in means) / (n - 1) / n) ** 0.5 if n > 2 else 0.0
    return mean, max(within, between)


def number(pair):
    return f"{pair[0]:.2f} ± {pair[1]:.2f}" if pair[1] else f"{pair[0]:.2f}"


def mean_over(folder, begin, end=float("inf")):
    """Means of the columns of a run's series between two strains, and the strain where it ends."""
    with open(folder / "series.csv") as file:
        names = [name.split("[")[0] for name in next(file).strip().split(",")]
        rows = [[float(v) for v in line.split(",")] for line in file]
    kept = [row for row in rows if begin <= row[0] <= end + 1e-9]
    return {name: sum(row[k] for row in kept) / len(kept) for k, name in enumerate(names)}, rows[-1][0]


def markdown(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows]) + "\n"
