package org.evoloop.program;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalInt;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import org.evoloop.config.Mistakes;
import org.evoloop.config.Option;
import org.evoloop.config.OptionLine;
import org.evoloop.config.Options;
import org.evoloop.config.Settings;
import org.evoloop.journal.Journal;
import org.evoloop.journal.JournalException;
import org.evoloop.loop.LoopConfig;
import org.evoloop.mqtt.MqttOptions;
import org.evoloop.page.PageOptions;
import org.evoloop.service.ErrorOutput;
import org.evoloop.service.Service;
import org.evoloop.service.ServiceOptions;
import org.evoloop.statemachine.ModelException;
import org.evoloop.xmi.ModelFiles;
import org.jspecify.annotations.Nullable;

/**
 * A converter as a program. It has a console, and by its options a control socket, a journal, a page with metrics, and
 * Home Assistant; each is off until the program's user asks for it.
 *
 * <pre>{@code
 * public static void main(String[] arguments) {
 *     System.exit(Program.named("lamp", "Gives a lamp a second light.")
 *             .models("models/lamp.xml", Main.class)
 *             .converter(Main::assemble)
 *             .run(arguments));
 * }
 * }</pre>
 *
 * <p>Threading: put together and run by one thread. Each run reads its options anew.
 *
 * @since 0.1
 */
public final class Program {
    private static final String COMMANDS =
            " It reads commands from standard input: start, status, history, exit; help lists all of them.";

    private final Options named;
    private String converter;
    private Options own = Options.of();
    private List<OptionLine> inFile = List.of();
    private @Nullable Option<Path> modelFile;
    private @Nullable Function<Settings, ProgramModels> models;
    private UnaryOperator<LoopConfig> loop = UnaryOperator.identity();
    private Assembler assembler = setup -> {};

    /** Assembles a program's parts. */
    @FunctionalInterface
    public interface Assembler {
        /**
         * Adds the parts. It must not touch the device, since {@code --print-config} assembles the program, too: what
         * does belongs into {@link ProgramSetup#onOpen}.
         *
         * @throws IOException if this computer lacks something; the message says what to do
         */
        void assemble(ProgramSetup setup) throws IOException, InterruptedException;
    }

    private Program(String name, String purpose) {
        this.converter = name;
        this.named = Options.named(name, purpose + COMMANDS);
    }

    /**
     * A program.
     *
     * @param name its name, which a configuration file gives after {@code program:}
     * @param purpose what it does, for {@code --help}
     */
    public static Program named(String name, String purpose) {
        return new Program(name, purpose);
    }

    /** Adds options of its own; {@link ProgramSetup#settings} has their values. */
    public Program options(Options... more) {
        own = own.and(more);
        return this;
    }

    /** Takes options from another file, too, over which the command line wins. */
    public Program options(List<OptionLine> lines) {
        inFile = List.copyOf(lines);
        return this;
    }

    /**
     * Takes both models from one file, that of the option {@code --models}, which has the machines {@code original} and
     * {@code new}.
     *
     * @param usual the file if the option is not given, see {@link ModelFiles#find}
     * @param application a class of the application
     */
    public Program models(String usual, Class<?> application) {
        Option<Path> file = Option.file(
                "models", "FILE", "A file with the machines 'original' and 'new' (default: " + usual + ").");
        modelFile = file;
        models = settings -> ProgramModels.in(settings.get(file).orElseGet(() -> ModelFiles.find(usual, application)));
        return this;
    }

    /** Takes the models from elsewhere; a {@link ModelException} of this supplier is a mistake of the program's user. */
    public Program models(Supplier<ProgramModels> read) {
        models = settings -> read.get();
        return this;
    }

    /** Changes the limits of the converter's loop; those that are the user's by an option are set already. */
    public Program loop(UnaryOperator<LoopConfig> limits) {
        loop = limits;
        return this;
    }

    /** Assembles the converter, which has the program's name, and what belongs to it. */
    public Program converter(Assembler parts) {
        return converter(converter, parts);
    }

    /**
     * Assembles the converter and what belongs to it.
     *
     * @param name the converter's, if it is not the program's
     */
    public Program converter(String name, Assembler parts) {
        converter = name;
        assembler = parts;
        return this;
    }

    /**
     * Runs the program until it ends. A mistake that its user can fix is one message on the standard error output.
     *
     * @return the exit status for the process: 0 success, 1 a failure while it ran, 2 wrong usage or input
     */
    public int run(String... arguments) {
        try {
            Settings settings = options().read(List.of(arguments), inFile, System.getenv());
            OptionalInt answered = settings.answer(System.out, System.err);
            return answered.isPresent() ? answered.getAsInt() : run(settings);
        } catch (ModelException | JournalException | IllegalArgumentException | IOException problem) {
            ErrorOutput.stream().println("error: " + problem.getMessage());
            return 2;
        } catch (InterruptedException end) {
            Thread.currentThread().interrupt();
            return 1;
        }
    }

    private Options options() {
        Options first = modelFile == null ? named : named.and(Options.of(modelFile));
        return first.and(ServiceOptions.OPTIONS, PageOptions.OPTIONS, MqttOptions.OPTIONS, own)
                .checking(this::check);
    }

    /**
     * Runs the program with options that its caller has read.
     *
     * @return the exit status for the process: 0 success, 1 a failure while it ran
     * @throws IOException if the control socket, the page or a part cannot be opened
     * @throws IllegalArgumentException if the name is taken
     * @throws ModelException if models and parts do not fit
     * @throws JournalException if the journal cannot be continued
     * @throws InterruptedException if the thread was interrupted while a part was being opened
     */
    public int run(Settings settings) throws IOException, InterruptedException {
        try (Service service = Service.open(ServiceOptions.of(settings))) {
            ProgramSetup setup = setup(settings, models == null ? null : models.apply(settings));
            try {
                assembler.assemble(setup);
                setup.build();
                return setup.run(service);
            } finally {
                setup.close();
            }
        }
    }

    private ProgramSetup setup(Settings settings, @Nullable ProgramModels read) {
        return new ProgramSetup(settings, read, converter, loop);
    }

    /** What a start would refuse, but for what only devices, and other programs, can tell. */
    private void check(Settings settings, Mistakes mistakes) {
        Function<Settings, ProgramModels> source = models;
        boolean named = modelFile != null && settings.get(modelFile).isPresent();
        if (source == null || !(named || settings.isOnlyShown())) {
            return;
        }
        ProgramModels read = mistakes.tried("models", Program::isUsersMistake, () -> {
            ProgramModels tried = source.apply(settings);
            if (settings.isOnlyShown()) {
                assembleOnly(settings, tried);
            }
            return tried;
        });
        Path journal = ServiceOptions.of(settings).journal();
        if (settings.isOnlyShown() && read != null && journal != null) {
            mistakes.tried("journal", Program::isUsersMistake, () -> {
                Journal.in(journal).check(read.pair());
                return journal;
            });
        }
    }

    private void assembleOnly(Settings settings, ProgramModels read) {
        ProgramSetup setup = setup(settings, read);
        try {
            assembler.assemble(setup);
            setup.buildOnly();
        } catch (IOException lacking) {
            throw new IllegalArgumentException(lacking.getMessage(), lacking);
        } catch (InterruptedException end) {
            Thread.currentThread().interrupt();
        } finally {
            setup.close();
        }
    }

    private static boolean isUsersMistake(Exception problem) {
        return problem instanceof ModelException
                || problem instanceof JournalException
                || problem instanceof IllegalArgumentException;
    }
}
