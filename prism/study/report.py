"""The report, as Markdown."""

from dataclasses import dataclass, field
from pathlib import Path

from study import disturbance_section, experiment_section, sections
from study.curves import Curves
from study.comparing import Comparison
from study.points import Mode
from study.proof import section as proof
from study.tables import Table


@dataclass
class Findings:
    """All findings of the study."""

    checker: str
    curves: Curves
    tables: dict[str, Table]
    flagged_baseline: float
    comparisons: list[Comparison] = field(default_factory=list)
    measured_events: dict[Mode, int] = field(default_factory=dict)


def write(folder: Path, findings: Findings) -> None:
    parts = [
        sections.head(findings.checker),
        sections.paper(findings.curves),
        sections.counting(findings.curves, findings.tables, findings.flagged_baseline),
        sections.converter(findings.curves, findings.tables),
        sections.devices(findings.curves, findings.tables),
        disturbance_section.disturbances(findings.curves, findings.tables),
        sections.sensitivity(findings.tables["sensitivity"]),
        sections.code(),
        experiment_section.experiment(findings.comparisons, findings.measured_events),
        sections.measured(findings.curves, findings.tables),
        proof.proof(findings.tables),
        sections.files(),
    ]
    (folder / "report.md").write_text("\n\n".join(parts) + "\n", encoding="utf-8")
