package org.evoloop.models;

import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import java.util.concurrent.CountDownLatch;
import org.evoloop.models.studio.StudioAnalysis;
import org.evoloop.studio.Studio;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Draws, checks and tries models in the browser. */
@Command(
        name = "studio",
        description = "Draws, checks and tries the models of a folder in this machine's browser; prints the address.",
        footer = {"", "Exit status: 2 wrong usage, or the folder or the port cannot be used. Ctrl-C ends it."},
        mixinStandardHelpOptions = true)
@SuppressWarnings("NullAway.Init") // picocli sets the fields
final class StudioCommand implements Callable<Integer> {
    private static final int HIGHEST_PORT = 65_535;

    @Spec
    private CommandSpec spec;

    @Parameters(
            arity = "0..1",
            paramLabel = "DIR",
            defaultValue = ".",
            description = "The folder with models and device files; nothing outside of it is read or written (default:"
                    + " the current one).")
    private Path directory;

    @Option(
            names = "--port",
            paramLabel = "N",
            defaultValue = "8090",
            description = "The port, on this machine only; 0 for any that is free (default: ${DEFAULT-VALUE}).")
    private int port;

    @Option(
            names = "--token-file",
            paramLabel = "FILE",
            description =
                    "Keeps the token in this file, which only its owner may read, so that open pages go on after a"
                            + " restart (default: a new token at each start).")
    private @Nullable Path tokenFile;

    @Override
    public Integer call() throws IOException, InterruptedException {
        if (port < 0 || port > HIGHEST_PORT) {
            throw new IllegalArgumentException("--port takes a port, 0 to " + HIGHEST_PORT + ", not " + port);
        }
        StudioAnalysis analysis = new StudioAnalysis();
        try (Studio studio = Studio.open(directory, port, tokenFile, analysis)) {
            Output.print(spec, studio.address() + "\n");
            // While the browser is being opened, so that the first picture is there at once.
            analysis.prepare();
            new CountDownLatch(1).await();
        }
        return 0;
    }
}
