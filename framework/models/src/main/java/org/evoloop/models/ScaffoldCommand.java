package org.evoloop.models;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.concurrent.Callable;
import org.evoloop.check.Check;
import org.evoloop.check.CheckInput;
import org.evoloop.check.Finding;
import org.evoloop.check.Rule;
import org.evoloop.evolution.ModelPair;
import org.evoloop.models.checking.Drawings;
import org.evoloop.models.checking.FindingsText;
import org.evoloop.models.scaffold.Scaffold;
import org.evoloop.models.scaffold.WrittenFile;
import org.evoloop.xmi.ModelReference;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.IModelTransformer;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.PositionalParamSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.Spec;

/** Generates a starter project for a converter. */
@Command(
        name = "scaffold",
        description = {
            "Creates the Maven project of a converter, which builds, passes its tests and runs at once.",
            "With --from, it turns a device file into Java, which then needs that file no more.",
            "It takes Evoloop's artifacts from your local Maven repository (~/.m2), into which "
                    + "'./evoloop models scaffold' installs them first."
        },
        mixinStandardHelpOptions = true,
        modelTransformer = ScaffoldCommand.ModelsOrFile.class)
@SuppressWarnings("NullAway.Init") // picocli sets the fields
final class ScaffoldCommand implements Callable<Integer> {
    private static final Set<String> BESIDE_FROM = Set.of("--from", "--package", "--out", "--update");

    @Spec
    private CommandSpec spec;

    @Mixin
    private PairOptions options;

    @Option(names = "--package", required = true, paramLabel = "P", description = "The Java package of its classes.")
    private String javaPackage;

    @Option(
            names = "--out",
            required = true,
            paramLabel = "DIR",
            description = "The directory of the project; it must not exist, or be empty, unless --update is given.")
    private Path directory;

    @Option(
            names = "--update",
            description =
                    "Brings the project in DIR up to date with the models; keeps what you wrote, and prints what is"
                            + " new.")
    private boolean update;

    @Option(
            names = "--from",
            paramLabel = "FILE.yaml",
            description = "In place of ORIGINAL and NEW: a device file, which is turned into Java.")
    private @Nullable Path from;

    @Mixin
    private PropertiesFile properties;

    /** Lets {@code --from} stand in for the models, which every other command needs. */
    static final class ModelsOrFile implements IModelTransformer {
        @Override
        public CommandSpec transform(CommandSpec command) {
            for (PositionalParamSpec model : List.copyOf(command.positionalParameters())) {
                command.remove(model);
                command.addPositional(PositionalParamSpec.builder(model)
                        .arity("0..1")
                        .required(false)
                        .build());
            }
            return command;
        }
    }

    @Override
    public Integer call() throws IOException {
        Scaffold.requirePackage(javaPackage);
        Scaffold.requireDirectory(directory, update);
        requireModelsOrFile();
        Scaffold.Request request = from == null ? ofModels() : ofFile(from);
        ModelPair pair = request.pair();
        List<Finding> errors = Check.run(CheckInput.of(pair).withDevice(request.device())).stream()
                .filter(finding -> finding.rule().severity() == Rule.Severity.ERROR)
                .toList();
        if (!errors.isEmpty()) {
            spec.commandLine()
                    .getErr()
                    .print(FindingsText.write(errors, List.of(), List.of(), drawings(request)::place));
            spec.commandLine().getErr().println("error: no converter of this pair could run; fix the models first");
            return 1;
        }
        List<String> report = Scaffold.write(request.withProperties(propertiesText(request)));
        return Output.print(
                spec,
                update
                        ? report.isEmpty() ? "nothing is new\n" : String.join("\n", report) + "\n"
                        : "wrote " + directory + "; go on with: cd " + directory + " && ./mvnw -q verify\n");
    }

    private void requireModelsOrFile() {
        ParseResult given = spec.commandLine().getParseResult();
        if (given.matchedPositionals().size() != (from == null ? 2 : 0)) {
            throw new ParameterException(
                    spec.commandLine(), "give either ORIGINAL and NEW, or a device file with --from FILE.yaml");
        }
        given.matchedOptions().stream()
                .map(OptionSpec::longestName)
                .filter(option -> from != null && !BESIDE_FROM.contains(option))
                .findFirst()
                .ifPresent(option -> {
                    throw new ParameterException(
                            spec.commandLine(), option + " does not go with --from; the device file says it");
                });
    }

    private Scaffold.Request ofModels() {
        ModelPair pair = options.read();
        return new Scaffold.Request(
                pair, options.device(pair), options.original(), options.evolved(), javaPackage, directory, null, null);
    }

    private Scaffold.Request ofFile(Path deviceFile) {
        WrittenFile written = WrittenFile.read(deviceFile);
        List<String> references = written.file().references();
        return new Scaffold.Request(
                written.file().models(),
                written.events(),
                ModelReference.parse(references.get(0)),
                ModelReference.parse(references.get(1)),
                javaPackage,
                directory,
                null,
                written);
    }

    private static Drawings drawings(Scaffold.Request request) {
        ModelPair pair = request.pair();
        return new Drawings(
                ModelReader.drawing(request.original(), pair.original()),
                ModelReader.drawing(request.evolved(), pair.evolved()));
    }

    /** The properties file's text, which is copied, or null if there is none. Fails if it cannot be parsed. */
    private @Nullable String propertiesText(Scaffold.Request request) throws IOException {
        Path named = request.written() == null
                ? null
                : request.written().file().properties().orElse(null);
        if (named != null) {
            return TextFile.read(named, "properties");
        }
        return properties.isThere(request.evolved()) ? properties.text(request.evolved(), request.pair()) : null;
    }
}
