"""What tests/style/run and tests/style/wrap share: the width, kinds of files, and the lines that may be longer."""

import re
import subprocess
from pathlib import Path

WIDTH = 110
ROOT = Path(__file__).resolve().parents[2]
CPP = (".cpp", ".hpp")
HASH = (".toml", ".sh", ".cmake", ".gp", ".py", ".yml", ".yaml")  # comments begin with #
HASH_NAMES = ("CMakeLists.txt", "Dockerfile", "run", "wrap", "pre-commit", "put_table", "instructions")


def kind_of(path):
    """cpp, md, hash (comments begin with #), text (any other), or None: no text of ours."""
    name = path.name
    if "corpus" in path.parts or path.suffix in (".msh", ".png", ".json", ".csv", ".inp", ".dict"):
        return None
    if path.suffix in CPP:
        return "cpp"
    if path.suffix == ".md":
        return "md"
    if path.suffix in HASH or name in HASH_NAMES or name.startswith(".clang"):
        return "hash"
    return "text"


def files(paths=()):
    """The files that git knows and those that are new, below PATHS (all when empty)."""
    command = ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard", *map(str, paths)]
    listed = subprocess.run(command, cwd=ROOT, capture_output=True, check=True).stdout.decode()
    return [ROOT / name for name in sorted(set(listed.split("\0"))) if name and (ROOT / name).is_file()]


def protected(lines):
    """Markdown lines that wrapping must leave alone: code blocks, tables, and what stands between markers
    `<!-- name -->` and `<!-- /name -->`, which the program writes."""
    left, fence, marker = set(), False, None
    for i, line in enumerate(lines):
        begin = re.match(r"\s*<!--\s*([\w:./-]+)[^>]*-->\s*$", line)
        if re.match(r"\s*(```|~~~)", line):
            fence = not fence
            left.add(i)
        elif fence or line.lstrip().startswith("|") or begin:
            left.add(i)
        elif marker:
            left.add(i)
        if begin and not fence:
            name = begin[1]
            if name.startswith("/"):
                marker = None
            elif any(re.match(r"\s*<!--\s*/" + re.escape(name) + r"\b", other) for other in lines[i + 1:]):
                marker = name
    return left


def in_raw_string(lines):
    """C++ lines within R"(..)" or R"TAG(..)TAG", and between `// clang-format off` and `on`."""
    inside, end, off = set(), None, False
    for i, line in enumerate(lines):
        off = "clang-format off" in line or (off and "clang-format on" not in line)
        if off:
            inside.add(i)
        elif end is None:
            for found in re.finditer(r'R"(\w*)\(', line):
                inside.add(i)
                if f'){found[1]}"' not in line[found.end():]:
                    end = f'){found[1]}"'
        else:
            inside.add(i)
            if end in line:
                end = None
    return inside


def too_long(path, lines):
    """Indices of lines beyond WIDTH that are not exempt: the page of tests/style/run says which are."""
    kind = kind_of(path)
    left = protected(lines) if kind == "md" else in_raw_string(lines) if kind == "cpp" else set()
    long = [i for i, line in enumerate(lines) if len(line) > WIDTH and i not in left]
    return [i for i in long if not unbreakable(lines[i], kind)]


def unbreakable(line, kind):
    if len(line.split()[-1]) + len(line) - len(line.lstrip()) + 4 > WIDTH or "://" in line[WIDTH - 40:]:
        return True
    # The shortest of its pieces that may not be broken: a quoted string (not in Markdown), or an inline table
    # of TOML.
    start = len(line) - len(line.lstrip())
    pieces = [] if kind == "md" else re.findall(r'"(?:[^"\\]|\\.)*"|\'[^\']*\'', line)
    if kind == "hash" and not line.lstrip().startswith("#"):
        pieces += re.findall(r"\{[^{}]*\}", line)
    return any(len(piece) + start > WIDTH - 8 for piece in pieces)
