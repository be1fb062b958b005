"""From ordered points to as few segments as keep a tolerance."""

from sgb_core.design.tracing.errors import TraceError
from sgb_core.design.tracing.result import Trace
from sgb_core.design.tracing.tracer import trace

__all__ = ["Trace", "TraceError", "trace"]
