"""Pictures of materials, textures and looks show what they name."""

import numpy as np
import pytest
from PySide6.QtGui import QImage

import resources
from app.panels.look.swatches import SIDE, look_swatch, material_swatch, texture_swatch
from app.state.picture_choice import TEXTURES
from sgb_core.document.appearance.finishes import FINISHES
from sgb_core.document.appearance.model import MaterialName


def pixels(icon):
    image = icon.pixmap(SIDE, SIDE).toImage().convertToFormat(QImage.Format.Format_RGBA8888)
    rows = np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), -1)
    return rows[:, : 4 * image.width()].reshape(image.height(), image.width(), 4).astype(int)


def middle(icon):
    drawn = pixels(icon)
    k = len(drawn) // 3
    return drawn[k:-k, k:-k, :3].reshape(-1, 3).mean(axis=0)


@pytest.mark.parametrize("name", MaterialName)
def test_a_ball_has_the_colour_of_its_material(qapp, name):
    finish = FINISHES[name]
    own = np.array([int(finish.color[k : k + 2], 16) for k in (1, 3, 5)])
    found = middle(material_swatch(finish))
    others = [np.array([int(f.color[k : k + 2], 16) for k in (1, 3, 5)]) for f in FINISHES.values()]
    # Lit and shaded, but of its own hue: as near to it as to any but whites among themselves.
    assert np.abs(found - own).max() < 110
    assert np.linalg.norm(found - own) <= 1.0 + max(np.linalg.norm(found - o) for o in others)
    # Round: nothing in the corners.
    assert pixels(material_swatch(finish))[0, 0, 3] == 0


def test_a_ball_takes_another_colour(qapp):
    red = middle(material_swatch(FINISHES[MaterialName.CLAY], "#c01010"))
    assert red[0] > 2.0 * max(red[1], red[2])


def test_textures_are_told_apart(qapp):
    patches = {name: pixels(texture_swatch(name)) for _, name in TEXTURES}
    names = list(patches)
    for k, first in enumerate(names):
        for second in names[k + 1 :]:
            assert np.abs(patches[first] - patches[second]).mean() > 3.0


def test_a_look_is_its_texture_or_its_material(qapp):
    assert look_swatch(None).isNull()
    for look in resources.looks():
        assert not look_swatch(look.appearance).isNull()
    lotus = next(look for look in resources.looks() if look.name == "pot-lotus")
    assert (pixels(look_swatch(lotus.appearance)) == pixels(texture_swatch("lotus"))).all()
