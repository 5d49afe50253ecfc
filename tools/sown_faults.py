"""Self-tests of the checks of src/: small trees with one fault sown, or none."""
import pathlib
import tempfile


def count_failures(checker, check, trees):
    """How many of `trees`, pairs of files {name: text} and a part of the one fault expected (None: no fault), `check` judges otherwise.

    `check` takes a folder and returns its faults, each a text.
    """
    failed = 0
    for files, expected in trees:
        with tempfile.TemporaryDirectory() as folder:
            for name, text in files.items():
                path = pathlib.Path(folder, name)
                path.parent.mkdir(exist_ok=True)
                path.write_text(text)
            faults = check(pathlib.Path(folder))
        good = not faults if expected is None else len(faults) == 1 and expected in faults[0]
        if not good:
            failed += 1
            print(f"self-test: {files}: expected {expected!r}, found {faults}")
    print(f"{checker}: {len(trees) - failed} of {len(trees)} self-tests passed")
    return failed
