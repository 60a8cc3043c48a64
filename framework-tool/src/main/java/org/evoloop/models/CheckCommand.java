package org.evoloop.models;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
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
import org.evoloop.models.temporal.PropertyCheck;
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
    private static final String PROPERTIES = ".properties.txt";

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

    @Option(
            names = "--properties",
            paramLabel = "FILE",
            description =
                    "Properties to check, a line each (default: the file beside NEW that is called like it and ends"
                            + " in " + PROPERTIES + ", if there is one).")
    private @Nullable Path properties;

    @Override
    public Integer call() throws IOException {
        ModelPair pair = options.read();
        CheckInput input = input(pair);
        List<Finding> findings = new ArrayList<>(Check.run(input));
        Path file = propertiesFile();
        boolean runs = findings.stream().noneMatch(CheckCommand::isNoEvolution);
        if (runs && (properties != null || Files.exists(file))) {
            findings.addAll(PropertyCheck.run(input, file.toString(), Files.readString(file)));
        }
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

    private Path propertiesFile() {
        Path models = options.evolved().file();
        String name = String.valueOf(models.getFileName());
        int dot = name.lastIndexOf('.');
        return properties != null
                ? properties
                : models.resolveSibling((dot > 0 ? name.substring(0, dot) : name) + PROPERTIES);
    }

    /** Where the pair is none, nothing can happen in it. */
    private static boolean isNoEvolution(Finding finding) {
        return switch (finding.rule()) {
            case CONDITION_1, CONDITION_2, INITIAL_DIFFERS -> true;
            default -> false;
        };
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
