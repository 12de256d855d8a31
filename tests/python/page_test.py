"""Runs the blocks of Python of a page, one after the other, and holds what each prints against the block of text below it.

page_test.py PAGE [--write]: --write puts what they print into the page. Blocks that draw are left out where there is no
matplotlib.
"""
import contextlib
import importlib.util
import io
import os
import re
import sys
import tempfile

page = os.path.abspath(sys.argv[1])
with open(page, encoding="utf-8") as file:
    text = file.read()
blocks = re.compile(r"```python\n(.*?)```\n(?:\n```text\n(.*?)```\n)?", re.S)
draws = importlib.util.find_spec("matplotlib") is not None
os.environ.setdefault("MPLBACKEND", "Agg")
names, wrong, ran = {}, 0, 0


def run(block):
    global wrong, ran
    code, stored = block[1], block[2] or ""
    if "matplotlib" in code and not draws:
        print("Left out: a block that needs matplotlib")
        return block[0]
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        exec(compile(code, page, "exec"), names)
    ran += 1
    if printed.getvalue() != stored:
        wrong += 1
        print(f"{code}printed\n{printed.getvalue()}the page has\n{stored}")
    return f"```python\n{code}```\n" + (f"\n```text\n{printed.getvalue()}```\n" if printed.getvalue() else "")


with tempfile.TemporaryDirectory() as folder:  # the figures
    os.chdir(folder)
    written = blocks.sub(run, text)
    os.chdir("/")
if "--write" in sys.argv:
    with open(page, "w", encoding="utf-8") as file:
        file.write(written)
print(f"{ran} blocks ran, {wrong} printed something else")
sys.exit(wrong > 0 or ran < 5)
