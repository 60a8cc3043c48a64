package org.evoloop.models;

import java.io.IOException;
import java.util.List;
import java.util.concurrent.Callable;
import org.evoloop.check.CheckInput;
import org.evoloop.check.Finding;
import org.evoloop.check.Rule;
import org.evoloop.check.RuleSwitches;
import org.evoloop.check.RuleSwitches.SwitchedOff;
import org.evoloop.check.timing.TimeReport;
import org.evoloop.evolution.ModelPair;
import org.evoloop.models.checking.Drawings;
import org.evoloop.models.checking.FindingDiagram;
import org.evoloop.models.checking.FindingsJson;
import org.evoloop.models.checking.FindingsText;
import org.evoloop.models.checking.SamePlace;
import org.evoloop.models.diagram.Diagram;
import org.evoloop.models.diagram.SvgWriter;
import org.evoloop.models.temporal.PairCheck;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Checks an evolution before it runs. */
@Command(
        name = "check",
        description = "Checks a pair of models by the rules in docs/models.md; exit status 1 if a rule is broken.",
        mixinStandardHelpOptions = true)
@SuppressWarnings("NullAway.Init") // picocli sets the fields
final class CheckCommand implements Callable<Integer> {
    @Spec
    private CommandSpec spec;

    @Mixin
    private PairOptions options;

    @Option(
            names = "--format",
            defaultValue = "TEXT",
            description =
                    "One of ${COMPLETION-CANDIDATES} (default: ${DEFAULT-VALUE}); svg draws the events that lead to"
                            + " each finding.")
    private OutputFormat format;

    @Mixin
    private ConverterOptions converter;

    @Mixin
    private PropertiesFile properties;

    @Override
    public Integer call() throws IOException {
        ModelPair pair = options.read();
        CheckInput input = converter.addTo(CheckInput.of(pair).withDevice(options.device(pair)));
        PairCheck check = PairCheck.run(input, () -> properties.read(options.evolved(), pair));
        List<Finding> all = check.findings();
        TimeReport times = check.times();
        if (!times.note().isEmpty()) {
            Output.note(spec, times.note());
        }
        check.written().switches().useless(all).forEach(useless -> Output.note(spec, useless));
        RuleSwitches switches = check.written().switches();
        Drawings drawings = options.drawings(pair);
        List<Finding> findings = SamePlace.merge(switches.left(all), drawings);
        List<SwitchedOff> off = switches.off(all);
        Output.print(
                spec,
                switch (format) {
                    case TEXT -> FindingsText.write(findings, off, times.verdicts(), drawings::place);
                    case JSON -> FindingsJson.write(findings, off, times.verdicts(), drawings::place);
                    case SVG -> picture(pair, findings);
                });
        times.undecided().forEach(message -> Output.error(spec, message));
        if (!times.undecided().isEmpty()) {
            return 2;
        }
        return findings.stream().allMatch(finding -> finding.rule().severity() == Rule.Severity.NOTE) ? 0 : 1;
    }

    private static String picture(ModelPair pair, List<Finding> findings) {
        List<Diagram> diagrams = findings.stream()
                .flatMap(finding -> FindingDiagram.of(pair, finding).stream())
                .toList();
        return SvgWriter.write(
                "Check of " + pair.original().name() + " and " + pair.evolved().name(),
                diagrams,
                FindingDiagram.timings(findings));
    }
}
