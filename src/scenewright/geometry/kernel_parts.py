"""How kernels and their parts are compiled: with numba's passes that kernels need, parts no further
than into the kernels that call them.

Numba optimizes every function together with all it calls and makes machine code of it. Of a
function that is copied into its callers nobody runs that code, so its callers take it as it was
before: each kernel is optimized once, as a whole. That takes a quarter off the time to compile.

Most of the rest is Python: numba's passes over each function. Closures, lists, Python's own objects
and expressions of whole arrays, which kernels do not have, need half of the passes. And a part that
is called with a constant is compiled for its type alone, not for each constant once more.
"""

from __future__ import annotations

from typing import Any

from numba.core.codegen import JITCodeLibrary
from numba.core.compiler import CompilerBase
from numba.core.compiler_machinery import PassManager
from numba.core.typed_passes import (
    IRLegalization,
    NativeLowering,
    NoPythonBackend,
    NopythonTypeInference,
    PreLowerStripPhis,
)
from numba.core.types.misc import unliteral
from numba.core.untyped_passes import (
    FixupArgs,
    GenericRewrites,
    IRProcessing,
    ReconstructSSA,
    TranslateByteCode,
)

PASSES = (
    TranslateByteCode,
    FixupArgs,
    IRProcessing,
    GenericRewrites,
    ReconstructSSA,
    NopythonTypeInference,
    PreLowerStripPhis,
    IRLegalization,
    NativeLowering,
    NoPythonBackend,
)
"""What numba does with a kernel."""


class NoEnvironment:
    """Code that never runs alone needs no environment."""

    def set_env(self, name: str, environment: Any) -> None:
        """Nothing to set."""


class PartLibrary(JITCodeLibrary):
    """The code of a part: ready to be linked into its callers, never run alone."""

    @property
    def codegen(self) -> Any:
        """Stands for the engine that would run it."""
        return NoEnvironment()

    def _optimize_final_module(self) -> None:
        """Left to the callers."""

    def _finalize_final_module(self) -> None:
        """No machine code."""
        self._finalize_dynamic_globals()
        self._finalized = True

    def get_pointer_to_function(self, name: str) -> int:  # noqa: ARG002
        """No address: it cannot be called."""
        self._ensure_finalized()
        return 0


class KernelCompiler(CompilerBase):
    """The passes of a kernel."""

    def define_pipelines(self) -> list[Any]:
        """One row of passes."""
        passes = PassManager("kernel")
        for each in PASSES:
            passes.add_pass(each, each.name())
        passes.finalize()
        return [passes]


class PartCompiler(CompilerBase):
    """The passes of a kernel with a :class:`PartLibrary`."""

    def define_pipelines(self) -> list[Any]:
        """One row of passes."""
        state = self.state
        state.library = PartLibrary(state.targetctx.codegen(), state.func_id.func_qualname)
        return KernelCompiler.define_pipelines(self)


def take_constants_by_type(kernel: Any) -> Any:
    """Make numba compile a kernel that others call for the types of constants, not for each."""
    template = kernel.get_call_template

    def get_call_template(args: Any, kws: Any) -> Any:
        """What numba asks of a function that is called."""
        plain = {name: unliteral(value) for name, value in kws.items()}
        return template(tuple(map(unliteral, args)), plain)

    kernel.get_call_template = get_call_template
    return kernel
