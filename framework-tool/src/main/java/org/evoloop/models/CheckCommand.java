package org.evoloop.models;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.function.Function;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.check.Check;
import org.evoloop.evolution.check.CheckInput;
import org.evoloop.evolution.check.Element;
import org.evoloop.evolution.check.Finding;
import org.evoloop.evolution.check.Rule;
import org.evoloop.models.checking.FindingDiagram;
import org.evoloop.models.checking.FindingsJson;
import org.evoloop.models.checking.FindingsText;
import org.evoloop.models.diagram.Diagram;
import org.evoloop.models.diagram.SvgWriter;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Checks an evolution before it runs. */
@Command(
        name = "check",
        description = "Checks an evolution by the rules that docs/models.md lists; exit status 1 if one is broken.",
        mixinStandardHelpOptions = true)
@SuppressWarnings("NullAway.Init") // picocli sets the fields
final class CheckCommand implements Callable<Integer> {
    /** How findings can be told. */
    enum Format {
        TEXT,
        JSON,
        SVG
    }

    @Spec
    private CommandSpec spec;

    @Mixin
    private PairOptions options;

    @Option(
            names = "--format",
            defaultValue = "TEXT",
            description = "One of ${COMPLETION-CANDIDATES} (default: ${DEFAULT-VALUE}); svg draws the ways that lead to"
                    + " findings.")
    private Format format;

    @Option(
            names = "--functions",
            split = ",",
            paramLabel = "STATE",
            description = "New states for which a function is registered; judged only if given.")
    private @Nullable List<String> functions;

    @Option(
            names = "--raised",
            split = ",",
            paramLabel = "EVENT",
            description = "Events that monitors and functions raise; judged only if given.")
    private @Nullable List<String> raised;

    @Option(
            names = "--guards",
            split = ",",
            paramLabel = "GUARD",
            description = "Guards that something is bound to; judged only if given.")
    private @Nullable List<String> guards;

    @Option(
            names = "--effects",
            split = ",",
            paramLabel = "EFFECT",
            description = "Effects that something is bound to; judged only if given.")
    private @Nullable List<String> effects;

    @Override
    public Integer call() {
        ModelPair pair = options.read();
        List<Finding> findings = Check.run(input(pair));
        Function<Element, String> places = options.places();
        Output.print(
                spec,
                switch (format) {
                    case TEXT -> FindingsText.write(findings, places);
                    case JSON -> FindingsJson.write(findings, places);
                    case SVG -> picture(pair, findings);
                });
        return findings.stream().allMatch(finding -> finding.rule().severity() == Rule.Severity.NOTE) ? 0 : 1;
    }

    private static String picture(ModelPair pair, List<Finding> findings) {
        List<Diagram> diagrams = findings.stream()
                .flatMap(finding -> FindingDiagram.of(pair, finding).stream())
                .toList();
        return SvgWriter.write(
                "Check of " + pair.original().name() + " and " + pair.evolved().name(), diagrams);
    }

    private CheckInput input(ModelPair pair) {
        CheckInput input = CheckInput.of(pair).withDevice(options.device(pair.original()));
        if (functions != null) {
            input = input.withFunctions(set(functions));
        }
        if (raised != null) {
            input = input.withRaised(set(raised));
        }
        if (guards != null) {
            input = input.withGuards(set(guards));
        }
        return effects != null ? input.withEffects(set(effects)) : input;
    }

    private static Set<String> set(List<String> names) {
        Set<String> stripped = new HashSet<>();
        names.forEach(name -> stripped.add(name.strip()));
        return stripped;
    }
}
