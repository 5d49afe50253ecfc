"""Measured memory bandwidth, and the time that the linear iterations of a run would take at that bandwidth."""
import json
import math
import subprocess

MEBIBYTE = 1024**2
SIZES = (4, 16, 64, 256, 1536)  # [MiB] of the triad's arrays together, about those of 1,000 to 1,000,000 particles
VECTOR = 8 * 4  # one vector of the linear solver, per body: 6 numbers in two lanes of 4, single precision
MET_TWICE = 1.15  # times that an edge is read: one between two blocks of bodies is met in both

# Bytes that one iteration of conjugate gradients moves (src/solve/conjugate_gradients.cpp, tangent.hpp), in single
# precision and without the coarse level. The one place to change when the solver changes. Writes count once, as in STREAM.
EDGE_TRAFFIC = {
    "TangentEdge, read": MET_TWICE * 48,
}
BODY_TRAFFIC = {
    "product: p read, q written": 2 * VECTOR,
    "inertia and damping, read": 2 * 4,
    "update: p, q, x, r read, x, r, z written": 7 * VECTOR,
    "inverse 6 x 6 block, read": 36 * 4,
    "direction: z, p read, p written": 3 * VECTOR,
}
# Bytes that stay in use from iteration to iteration: whether they fit a cache decides which bandwidth holds.
EDGE_RESIDENT = MET_TWICE * 48
BODY_RESIDENT = 5 * VECTOR + 36 * 4 + 2 * 4


def bytes_per_iteration(bodies, edges):
    return bodies * sum(BODY_TRAFFIC.values()) + edges * sum(EDGE_TRAFFIC.values())


def resident_bytes(bodies, edges):
    return bodies * BODY_RESIDENT + edges * EDGE_RESIDENT


def measure(build):
    """Builds the triad in a build folder and runs it: a list of {"MiB", "threads", "GB/s"}."""
    subprocess.run(["cmake", "--build", str(build), "--target", "triad"], check=True, stdout=subprocess.DEVNULL)
    said = subprocess.run([str(build / "tools/benchmarks/triad"), *map(str, SIZES)], check=True, capture_output=True, text=True)
    return json.loads(said.stdout)


def bandwidth_for(table, size, threads):
    """Bandwidth [byte/s] of the arrays nearest in size [byte] (by ratio) and nearest in threads."""
    best = min(table, key=lambda row: (abs(math.log(row["MiB"] * MEBIBYTE / size)), abs(row["threads"] - threads)))
    return 1e9 * best["GB/s"]


def roofline(entry, table):
    """What the linear iterations of a case move, and the time that takes at the measured bandwidth.

    Edges are the contacts, their mean over the run: gaps that may close add a few per cent.
    """
    figures = entry["median"]
    bodies, edges = entry["particles"], figures["contacts"]
    size, moved = resident_bytes(bodies, edges), bytes_per_iteration(bodies, edges)
    bandwidth = bandwidth_for(table, size, entry["threads"])
    seconds = figures["linear"] * moved / bandwidth
    return {"resident [MB]": size / 1e6, "moved per iteration [MB]": moved / 1e6, "bandwidth [GB/s]": bandwidth / 1e9,
            "iterations": figures["linear"], "time at bandwidth [s]": seconds, "measured step time [s]": figures["step wall [s]"],
            "share": seconds / figures["step wall [s]"]}
