"""Storm, called through stormpy."""

import importlib.util
import subprocess
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

from study.checking import Answers, Constants, Number, combinations, model_file, property_file, varying
from study.problem import Problem

_PRECISION = "1/10000000000"


def has_stormpy() -> bool:
    return importlib.util.find_spec("stormpy") is not None


class Storm:
    """Checks with Storm; reads each file once."""

    name = "Storm"

    def __init__(self) -> None:
        try:
            import stormpy
            import stormpy.developer
        except ImportError as cause:
            raise Problem(
                f"stormpy cannot be loaded ({cause}); remove prism/.venv and try again, "
                "or put PRISM on the PATH and use --checker prism"
            ) from cause
        self._stormpy = stormpy
        # Storm warns about each command in PRISM's syntax; its errors are also raised as exceptions.
        stormpy.developer.set_log_level(stormpy.developer.LogLevel.OFF)
        self._environment = stormpy.Environment()
        self._environment.solver().native().precision = stormpy.Rational(_PRECISION)
        self._parsed: dict[tuple[str, str], tuple[Any, list[Any]]] = {}

    def check(self, model: str, properties: str, constants: Constants) -> Answers:
        answers = Answers()
        try:
            program, questions = self._read(model, properties)
            undefined = _undefined(program)
            varied = varying(constants)
            fixed = {name: value for name, value in constants.items() if not isinstance(value, Sequence)}
            asked = list(self._instances(program, questions, fixed, varied))
            for of_model in combinations({name: varied[name] for name in varied if name in undefined}):
                built = self._build(program, undefined, [question for question, _ in asked], {**fixed, **of_model})
                for question, given in asked:
                    key = {**of_model, **{name: given[name] for name in given if name in varied}}
                    answers.put(question.get_name(), key, self._value(built, question, given))
        except RuntimeError as cause:
            raise Problem(f"{model_file(model)} with {property_file(properties).name}: {_reason(cause)}") from cause
        return answers

    def _instances(
        self, program: Any, questions: list[Any], fixed: dict[str, Number], varied: dict[str, Sequence[Number]]
    ) -> Iterator[tuple[Any, dict[str, Number]]]:
        """Each property with each combination of the constants on which it depends."""
        for question in questions:
            used = {variable.name: variable for variable in question.get_undefined_constants()}
            for chosen in combinations({name: varied[name] for name in varied if name in used}):
                given = _given(used, {**fixed, **chosen})
                _, instantiated = self._stormpy.instantiate_constants(program, given, [question])
                yield instantiated[0], given

    def _read(self, model: str, properties: str) -> tuple[Any, list[Any]]:
        # A program keeps the constants of the properties read with it, so each pair has its own.
        if (model, properties) not in self._parsed:
            program_path, property_path = model_file(model), property_file(properties)
            for path in (program_path, property_path):
                if not path.is_file():
                    raise Problem(f"{path} is missing; restore it, for example with git checkout")
            try:
                program = self._stormpy.parse_prism_program(str(program_path), prism_compatibility=True)
                questions = self._stormpy.parse_properties(property_path.read_text(encoding="utf-8"), program)
            except RuntimeError as cause:
                if str(cause) == "std::exception":
                    # Storm reports the reason for some errors, such as unknown names, only in its log.
                    raise RuntimeError(self._logged(program_path, property_path)) from cause
                raise
            self._parsed[model, properties] = program, list(questions)
        return self._parsed[model, properties]

    def _logged(self, program_path: Path, property_path: Path) -> str:
        """What Storm logs when it reads the files. In a separate process, since the log cannot be captured otherwise."""
        script = (
            "import sys, stormpy as s, stormpy.developer as d; d.set_log_level(d.LogLevel.ERR); "
            "p = s.parse_prism_program(sys.argv[1], prism_compatibility=True); "
            "s.parse_properties(open(sys.argv[2], encoding='utf-8').read(), p)"
        )
        command = [sys.executable, "-c", script, str(program_path), str(property_path)]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        logged = [line for line in (done.stdout + done.stderr).splitlines() if line.startswith("ERROR")]
        return logged[0].split("): ", maxsplit=1)[-1] if logged else "Storm cannot read it"

    def _build(
        self, program: Any, undefined: dict[str, Any], questions: list[Any], constants: dict[str, Number]
    ) -> Any:
        instantiated, _ = self._stormpy.instantiate_constants(program, _given(undefined, constants))
        return self._stormpy.build_model(instantiated, questions)

    def _value(self, built: Any, question: Any, given: dict[str, Number]) -> float:
        formula = question.get_raw_formula()
        if given.get("T") == 0 and type(formula.subformula).__name__ == "CumulativeRewardFormula":
            return 0.0  # Storm refuses C<=0
        result = self._stormpy.model_checking(built, question, environment=self._environment)
        return float(result.get_value(built.initial_states[0]))


def _undefined(program: Any) -> dict[str, Any]:
    """The constants of a model that need a value, by name."""
    return {constant.name: constant.expression_variable for constant in program.constants if not constant.defined}


def _given(variables: dict[str, Any], values: dict[str, Number]) -> dict[str, Number]:
    """The values of these variables, in the types that they are declared with."""
    for name in variables:
        if name not in values:
            raise Problem(f"the constant {name} has no value")
    return {
        name: float(values[name]) if variable.has_rational_type() else int(values[name])
        for name, variable in variables.items()
    }


def _reason(cause: BaseException) -> str:
    """Storm's error message in one line, without the exception's name."""
    words = " ".join(str(cause).replace("^", " ").split())
    return words.split("Exception: ", maxsplit=1)[-1]
