"""The user's own places are nobody else's: modes are tight, and no link in their place is followed.

How files that are saved keep their mode: tests/sgb_core/document/file/test_atomic.py.
"""

import os
import shutil
import stat
import sys
from contextlib import suppress

import pytest

from app.state import user_folders
from app.state.log import Log
from sgb_core.document.errors import FileError
from sgb_core.document.file import private, project_file
from sgb_core.document.file.journal import Journal
from sgb_core.document.file.versions import backup_place, keep_backup
from tests.app.helpers import tower

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="has no modes")


def keep_log():
    log = Log()
    log.write("a line")
    log.close()
    return log.path


def keep_journal():
    journal = Journal(user_folders.recovery(), user_folders.locks())
    journal.write(tower())
    journal.close()
    return journal.entry


def keep_lock():
    private.unlock(private.lock(user_folders.locks(), "name"))
    return user_folders.locks() / "name.lock"


@pytest.fixture
def keep_version(tmp_path):
    project = tmp_path / "pot.sgb"
    project_file.save(tower(), project)
    project.chmod(0o644)

    def keep():
        keep_backup(project, user_folders.backups())
        return backup_place(project, user_folders.backups())

    return keep


@pytest.fixture(params=["log", "recovery", "locks", "backups"])
def kept(request, faults_are_for_the_tests, keep_version):
    """What keeps something in a folder of the user's, and the folder, which is not there yet."""
    place = getattr(user_folders, request.param)()
    ways = {"log": keep_log, "recovery": keep_journal, "locks": keep_lock, "backups": keep_version}
    _remove(place)
    # Others may read what is made without further ado.
    mask = os.umask(0o022)
    yield ways[request.param], place
    os.umask(mask)
    _remove(place)


def _remove(place):
    if place.is_symlink():
        place.unlink()
    shutil.rmtree(place, ignore_errors=True)


def test_what_is_kept_is_the_users_alone(kept):
    keep, place = kept
    file = keep()
    assert stat.S_IMODE(file.stat().st_mode) == 0o600
    assert stat.S_IMODE(place.stat().st_mode) == 0o700
    # A folder that somebody has opened is closed again.
    place.chmod(0o755)
    keep()
    assert stat.S_IMODE(place.stat().st_mode) == 0o700


def test_a_link_in_the_place_of_a_folder_is_not_followed(kept, tmp_path):
    keep, place = kept
    victim = tmp_path / "victim"
    victim.mkdir(mode=0o755)
    place.parent.mkdir(parents=True, exist_ok=True)
    place.symlink_to(victim)
    with suppress(OSError, FileError):
        keep()
    assert list(victim.iterdir()) == []
    assert stat.S_IMODE(victim.stat().st_mode) == 0o755
