"""What may differ between two runs of one build, and is left out of comparisons: times, and what follows from times.

  JSON         numbers of keys that end with "seconds" and "retries"; of a chart's tables the columns TIMED
  CSV          the columns TIMED
  text, pages  "0.25 s", "3.1 M pairs/s", and the columns "CPU s" of tables
  charts       svg, png, gp: drawn from times, so that only their being there is compared
  all          the folder in which a command ran
"""

import csv
import io
import json
import re

# Of a chart: times, their quartiles, how often was timed, what is made from a time, and what no faster choice beats.
TIMED = re.compile(r"(ns|us)(_.*)?|\w*seconds\w*|repetitions|front|pairs_per_second")
NUMBER = r"[-+]?\d[\d.]*(?:e[-+]?\d+)?"
SECONDS_KEY = re.compile(r'("\w*seconds"|"retries"): ' + NUMBER)
SECONDS = re.compile(NUMBER + r"(?= s\b)|" + NUMBER + r"(?= M (?:pairs|samples)/s)")


def without_columns(rows):
    """Rows of a table, the first of which names the columns, without those of time."""
    keep = [i for i, name in enumerate(rows[0]) if not TIMED.fullmatch(name)]
    return [[row[i] for i in keep if i < len(row)] for row in rows]


def chart_json(text):
    chart = json.loads(text)
    chart.pop("effort", None)
    for table in chart["tables"]:
        table["rows"] = [{name: cell for name, cell in row.items() if not TIMED.fullmatch(name)} for row in table["rows"]]
    return json.dumps(chart, indent=1)


def csv_text(text):
    out = io.StringIO()
    csv.writer(out).writerows(without_columns(list(csv.reader(io.StringIO(text)))))
    return out.getvalue()


def without_cpu_seconds(text):
    """Tables, in Markdown or aligned by spaces, without what stands below "CPU s", their last column."""
    lines, cells, width = [], None, None
    for line in text.splitlines():
        if "CPU s" in line:
            cells = line.split("|").index(" CPU s ") if line.startswith("|") else None
            width = None if cells else line.index("CPU s")
        elif not line.strip():
            cells = width = None
        elif cells:
            line = "|".join(line.split("|")[:cells])
        lines.append(line[:width])
    return "\n".join(lines)


def masked(path, folder):
    """What of a file or stream is compared, as bytes; folder is that in which the command ran."""
    chart = (path.parent / "chart.json").exists()
    if chart and path.suffix in (".svg", ".png", ".gp"):
        return b"drawn from times"
    content = path.read_bytes().replace(str(folder).encode(), b"FOLDER")
    try:
        text = content.decode()
    except UnicodeDecodeError:
        return content
    if chart and path.suffix == ".csv":
        text = csv_text(text)
    elif path.name == "chart.json":
        text = chart_json(text)
    elif path.suffix in ("", ".md", ".txt", ".json"):
        text = SECONDS.sub("*", without_cpu_seconds(SECONDS_KEY.sub(r"\1: *", text)))
    return text.encode()
