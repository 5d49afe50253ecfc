"""A claim of the validation: what was expected, what was obtained, and the table of all."""
import dataclasses
import typing


@dataclasses.dataclass
class Claim:
    name: str
    reference: str
    obtained: str
    tolerance: str
    passed: typing.Optional[bool]  # None: skipped

    def verdict(self):
        return {True: "yes", False: "NO", None: "skipped"}[self.passed]

    def cells(self):
        return [self.name, self.reference, self.obtained, self.tolerance, self.verdict()]


def is_equal(name, reference, obtained, tolerance):
    """Claim that a figure agrees with its reference to a relative tolerance."""
    error = abs(obtained / reference - 1)
    return Claim(name, f"{reference:.8g}", f"{obtained:.8g} (off by {error:.1e})", f"{tolerance:.0e}", error <= tolerance)


def is_below(name, what, value, limit):
    """Claim that a figure, named by `what`, is not above a limit."""
    return Claim(name, what, f"{value:.2e}", f"<= {limit:.0e}", value <= limit)


def is_above(name, what, value, limit):
    return Claim(name, what, f"{value:.2f}", f">= {limit:g}", value >= limit)


def is_reported(name, what, text):
    """A figure that is told and not judged."""
    return Claim(name, what, text, "told", True)


def is_skipped(name, reason):
    return Claim(name, "", reason, "", None)


def has_failed(name, reason):
    return Claim(name, "a finished run", reason, "", False)


HEADER = ["claim", "reference", "obtained", "tolerance", "pass"]


def markdown(claims):
    lines = ["| " + " | ".join(HEADER) + " |", "|" + "---|" * len(HEADER)]
    lines += ["| " + " | ".join(cell.replace("|", "/") for cell in claim.cells()) + " |" for claim in claims]
    return "\n".join(lines)


def print_claim(claim):
    print(f"  {claim.verdict():>7}  {claim.name}: {claim.obtained}"
          + (f"  [{claim.reference}; {claim.tolerance}]" if claim.passed is not None else ""), flush=True)


def write_between(path, marker, text):
    """Replaces what stands between <!-- marker:begin --> and <!-- marker:end --> in a file."""
    begin, end = f"<!-- {marker}:begin -->", f"<!-- {marker}:end -->"
    whole = path.read_text(encoding="utf-8")
    before, rest = whole.split(begin)
    path.write_text(before + begin + "\n" + text + "\n" + end + rest.split(end)[1], encoding="utf-8")
