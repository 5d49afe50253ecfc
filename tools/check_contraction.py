#!/usr/bin/env python3
"""Checks that no product and sum of ours were fused into one rounding: debug, release and other compilers then have the same bits
(docs/decisions/0006). -ffp-contract=off forbids it, but the vectoriser of g++ 12 fuses in spite of it (cmake/frit_target.cmake).

    tools/check_contraction.py BUILD        looks through the objects of a release build with objdump (binutils)

Eigen asks for fused instructions in its products of matrices, by name and at every level of optimisation: packed ones, in the files of
EIGEN_FUSES, and scalar ones in large products. Everywhere else they are faults, alternating ones (fmaddsub) in every file. Exits with 1 on
faults, with 77 (skipped) without objdump or objects. `--self-test` proves that each kind is found.
"""
import argparse
import pathlib
import re
import shutil
import subprocess
import sys

# Their numbers become pixels or text.
NO_RESULTS = {"app", "python", "report"}
# The kinds that Eigen asks for in src/<folder>/<name>. Before one is added: compile it with -g, `objdump -d -l --inlines`, and every fused
# instruction comes from Eigen's pmadd.
EIGEN_FUSES = {name: {"packed"} for name in (
    "analyze/snapshots.cpp", "integrate/stable_step.cpp", "observe/motion.cpp", "observe/non_affine.cpp", "observe/rearrangement.cpp",
    "observe/union_volume.cpp", "solve/block_jacobi.cpp", "solve/central_factor.cpp", "solve/coarse_level.cpp",
    "solve/conjugate_gradients.cpp", "solve/gauss_seidel.cpp")} | {"solve/partial_cholesky.cpp": {"packed", "scalar"}}
FUSED = re.compile(r"\tv(fmaddsub|fmsubadd|fn?m(?:add|sub))\d*([ps])[sdh]\b")


def counts_of(listing):
    """How many fused instructions of each kind objdump's listing shows."""
    counts = {"alternating": 0, "scalar": 0, "packed": 0}
    for name, width in FUSED.findall(listing):
        if name in ("fmaddsub", "fmsubadd"):
            counts["alternating"] += 1
        else:
            counts["packed" if width == "p" else "scalar"] += 1
    return counts


def faults_of(source, listing):
    """What is wrong in the object of src/`source`."""
    for kind, count in counts_of(listing).items():
        if count > 0 and kind not in EIGEN_FUSES.get(source, ()):
            yield (f"src/{source}: {count} {kind} fused multiply-add instructions that nobody asked for; "
                   "compile it with ${frit_uncontracted} (cmake/frit_target.cmake)")


def objects(build):
    """(source relative to src/, object) of the libraries whose numbers are results."""
    for path in sorted(build.glob("src/*/CMakeFiles/frit_*.dir/*.cpp.o")):
        folder = path.relative_to(build).parts[1]
        if folder not in NO_RESULTS:
            yield f"{folder}/{path.name[:-2]}", path


def self_test():
    """Each kind alone, in a file where Eigen's are allowed and in one where they are not."""
    kinds = {"alternating": "\tvfmaddsub231pd %xmm1,%xmm2,%xmm3\n", "scalar": "\tvfnmadd132sd 0x8(%rax),%xmm2,%xmm3\n",
             "packed": "\tvfmadd213ps %ymm1,%ymm2,%ymm3\n"}
    for kind, line in kinds.items():
        listing = "\tvmulpd %ymm1,%ymm2,%ymm3\n\tvaddsubpd %ymm1,%ymm2,%ymm3\n" + line
        for source, is_fault in (("solve/newton.cpp", True), ("solve/coarse_level.cpp", kind != "packed")):
            if [kind in fault for fault in faults_of(source, listing)] != [True] * is_fault:
                sys.exit(f"self-test: {kind} in {source} is judged wrongly")
    print("check_contraction: each kind of fused instruction is found")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build", nargs="?", type=pathlib.Path, default=pathlib.Path("build/release"))
    parser.add_argument("--self-test", action="store_true")
    arguments = parser.parse_args()
    if arguments.self_test:
        return self_test()
    if shutil.which("objdump") is None:
        print("skipped: objdump is not installed (binutils)")
        return 77
    found = list(objects(arguments.build))
    if not found:
        print(f"skipped: {arguments.build} has no objects of src/")
        return 77
    faults = []
    for source, path in found:
        listing = subprocess.run(["objdump", "-d", "--no-show-raw-insn", path], capture_output=True, text=True, check=True).stdout
        faults += faults_of(source, listing)
    print("\n".join(faults) if faults else f"{len(found)} objects: no fused instructions but those that Eigen asks for by name")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
