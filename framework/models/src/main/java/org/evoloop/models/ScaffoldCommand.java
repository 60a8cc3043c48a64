package org.evoloop.models;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import org.evoloop.check.Check;
import org.evoloop.check.CheckInput;
import org.evoloop.check.Finding;
import org.evoloop.check.Rule;
import org.evoloop.evolution.DeviceEvents;
import org.evoloop.evolution.ModelPair;
import org.evoloop.models.checking.FindingsText;
import org.evoloop.models.scaffold.Scaffold;
import org.evoloop.xmi.ModelReference;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Generates a starter project for a converter. */
@Command(
        name = "scaffold",
        description = {
            "Creates the Maven project of a converter, which builds, passes its tests and runs at once.",
            "It takes Evoloop's artifacts from your local Maven repository (~/.m2), into which "
                    + "'./evoloop models scaffold' installs them first."
        },
        mixinStandardHelpOptions = true)
@SuppressWarnings("NullAway.Init") // picocli sets the fields
final class ScaffoldCommand implements Callable<Integer> {
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

    @Mixin
    private PropertiesFile properties;

    @Override
    public Integer call() throws IOException {
        Scaffold.requirePackage(javaPackage);
        Scaffold.requireDirectory(directory, update);
        ModelPair pair = options.read();
        DeviceEvents device = options.device(pair);
        List<Finding> errors = Check.run(CheckInput.of(pair).withDevice(device)).stream()
                .filter(finding -> finding.rule().severity() == Rule.Severity.ERROR)
                .toList();
        if (!errors.isEmpty()) {
            spec.commandLine()
                    .getErr()
                    .print(FindingsText.write(errors, List.of(), List.of(), options.drawings(pair)::place));
            spec.commandLine().getErr().println("error: no converter of this pair could run; fix the models first");
            return 1;
        }
        List<String> report = Scaffold.write(new Scaffold.Request(
                pair, device, options.original(), options.evolved(), javaPackage, directory, propertiesText(pair)));
        return Output.print(
                spec,
                update
                        ? report.isEmpty() ? "nothing is new\n" : String.join("\n", report) + "\n"
                        : "wrote " + directory + "; go on with: cd " + directory + " && ./mvnw -q verify\n");
    }

    /** The properties file's text, which is copied, or null if there is none. Fails if it cannot be parsed. */
    private @Nullable String propertiesText(ModelPair pair) throws IOException {
        ModelReference evolved = options.evolved();
        return properties.isThere(evolved) ? properties.text(evolved, pair) : null;
    }
}
