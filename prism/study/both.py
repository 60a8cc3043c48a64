"""Two checkers at once."""

from study.checking import Answers, Checker, Constants


class Both:
    """Queries both checkers, returns the first one's values and records how far apart they were."""

    def __init__(self, first: Checker, second: Checker) -> None:
        self.name = f"{first.name} and {second.name}"
        self.largest_difference = 0.0
        self._first = first
        self._second = second

    def check(self, model: str, properties: str, constants: Constants) -> Answers:
        answers = self._first.check(model, properties, constants)
        others = self._second.check(model, properties, constants)
        # Transient values have an absolute precision; for the others PRISM solves equations to a relative one.
        difference = answers.largest_difference(others, relative=properties != "paper")
        self.largest_difference = max(self.largest_difference, difference)
        return answers
