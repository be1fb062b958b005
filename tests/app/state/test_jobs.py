"""Jobs run aside and end in exactly one of three ways, told on the GUI thread."""

import threading

from app.state.jobs import Job, Jobs
from sgb_core.interruption import checkpoint


def run(qtbot, work, *, cancel=False):
    jobs = Jobs()
    seen = []
    job = Job(
        "work",
        work,
        lambda result: seen.append(("done", result, threading.current_thread())),
        lambda error: seen.append(("failed", str(error), threading.current_thread())),
        lambda: seen.append(("cancelled", None, threading.current_thread())),
    )
    if cancel:
        job.cancel()
    jobs.start(job)
    assert jobs.running == [job]
    qtbot.waitUntil(lambda: bool(seen))
    assert jobs.running == []
    assert len(seen) == 1
    outcome, value, thread = seen[0]
    assert thread is threading.main_thread()
    return outcome, value


def test_a_result_comes_back(qtbot):
    workers = []

    def work(report):
        workers.append(threading.current_thread())
        report(0.5)
        return 42

    assert run(qtbot, work) == ("done", 42)
    assert workers[0] is not threading.main_thread()


def test_an_error_comes_back(qtbot):
    def work(report):
        raise OSError("disk full")

    assert run(qtbot, work) == ("failed", "disk full")


def test_a_cancelled_job_stops_at_its_next_report(qtbot):
    passed = []

    def work(report):
        report(0.1)
        passed.append(True)

    assert run(qtbot, work, cancel=True) == ("cancelled", None)
    assert not passed


def test_a_cancelled_job_stops_at_its_next_checkpoint(qtbot):
    passed = []

    def work(report):
        checkpoint()
        passed.append(True)

    assert run(qtbot, work, cancel=True) == ("cancelled", None)
    assert not passed
    assert run(qtbot, work) == ("done", None)
    assert passed


def test_a_dropped_job_is_not_heard_of_even_where_it_has_ended(qtbot):
    jobs, seen, ended = Jobs(), [], threading.Event()

    def work(report):
        ended.set()
        return 42

    calls = (seen.append, seen.append, lambda: seen.append("cancelled"))
    jobs.start(Job("old", work, *calls))
    assert ended.wait(60.0)
    jobs.wait()
    # It has ended; its result waits for the GUI thread.
    jobs.drop_all()
    jobs.start(Job("new", lambda report: 43, *calls))
    qtbot.waitUntil(lambda: jobs.running == [])
    assert seen == [43]


def test_jobs_run_in_turn(qtbot):
    jobs = Jobs()
    order = []
    for number in range(4):
        jobs.start(Job(str(number), lambda report, n=number: n, order.append, order.append))
    qtbot.waitUntil(lambda: len(order) == 4)
    assert order == [0, 1, 2, 3]


def test_once_closed_nothing_starts_any_more():
    jobs, ran = Jobs(), []
    jobs.start(Job("first", lambda _report: ran.append(1), lambda _: None, lambda _: None))
    jobs.close()
    jobs.start(Job("late", lambda _report: ran.append(2), lambda _: None, lambda _: None))
    jobs.wait()
    assert ran == [1]
