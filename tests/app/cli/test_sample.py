"""The ``sample`` command with curvature: CSV that goes on where it ended, and figures."""

from __future__ import annotations

from app.cli.parser import main


def test_sample_with_curvature(qapp, tmp_path, capsys):
    path = tmp_path / "vase.sgb"
    assert main(["new", "vase", str(path)]) == 0
    capsys.readouterr()
    assert main(["sample", str(path), "--curvature", "--per-segment", "5"]) == 0
    head, *rows = capsys.readouterr().out.splitlines()
    assert head == "segment,s,r,h,length,curvature,deviation"
    assert main(["sample", str(path), "--per-segment", "5"]) == 0
    plain = capsys.readouterr().out.splitlines()[1:]
    # What it said before it says still, with more behind it.
    assert [row.rsplit(",", 3)[0] for row in rows] == plain
    lengths = [float(row.split(",")[4]) for row in rows]
    assert lengths == sorted(lengths)
    for suffix in (".csv", ".pdf", ".svg", ".png"):
        out = tmp_path / f"k{suffix}"
        assert main(["sample", str(path), "--curvature", "--out", str(out)]) == 0
        assert out.stat().st_size > 1000
    assert (tmp_path / "k.pdf").read_bytes().startswith(b"%PDF-1.7")
    assert not (tmp_path / "k.csv.json").exists()
    again = tmp_path / "again.png"
    made = [str(tmp_path / "k.png.json"), "--curvature", "--out", str(again)]
    assert main(["sample", *made]) == 0
    assert again.read_bytes() == (tmp_path / "k.png").read_bytes()
