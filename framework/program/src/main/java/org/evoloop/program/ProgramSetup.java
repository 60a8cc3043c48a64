package org.evoloop.program;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import org.evoloop.check.timing.TimeWatch;
import org.evoloop.config.Settings;
import org.evoloop.console.Console;
import org.evoloop.console.ConsoleCommand;
import org.evoloop.console.NewModels;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.evolution.ModelPair;
import org.evoloop.journal.Journal;
import org.evoloop.loop.LoopConfig;
import org.evoloop.mqtt.MqttOptions;
import org.evoloop.mqtt.home.HomeAssistant;
import org.evoloop.page.ModelPicture;
import org.evoloop.page.Page;
import org.evoloop.page.PageOptions;
import org.evoloop.page.Picture;
import org.evoloop.service.Service;
import org.evoloop.service.ServiceOptions;
import org.evoloop.time.Clock;
import org.evoloop.time.SystemClock;
import org.evoloop.xmi.ModelFile;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * What a program is assembled from. {@link Program} then builds the converter with the journal that its user asks for,
 * opens the parts, and runs the console.
 *
 * <p>Threading: used by the thread that runs the program.
 *
 * @since 0.1
 */
public final class ProgramSetup {
    private static final Logger LOG = LoggerFactory.getLogger(ProgramSetup.class);

    private final Settings settings;
    private final @Nullable ProgramModels models;
    private final String name;
    private final UnaryOperator<LoopConfig> loop;
    private final List<ConsoleCommand> commands = new ArrayList<>();
    private final List<Picture> pictures = new ArrayList<>();
    private final List<Opening> openings = new ArrayList<>();
    private final Deque<AutoCloseable> belongings = new ArrayDeque<>();
    private @Nullable Clock clock;
    private @Nullable SystemEventConverter converter;
    private boolean built;
    private @Nullable NewModels others;
    private Consumer<HomeAssistant> home = shown -> {};

    /** Opens a part of a program. */
    @FunctionalInterface
    public interface Opening {
        /**
         * Opens it.
         *
         * @throws IOException if it cannot be opened; the message says what to do
         */
        void open() throws IOException, InterruptedException;
    }

    ProgramSetup(Settings settings, @Nullable ProgramModels models, String name, UnaryOperator<LoopConfig> loop) {
        this.settings = settings;
        this.models = models;
        this.name = name;
        this.loop = loop;
    }

    /** The options given to the program. */
    public Settings settings() {
        return settings;
    }

    /**
     * The program's models.
     *
     * @throws IllegalStateException if the program has been told none
     */
    public ModelPair models() {
        if (models == null) {
            throw new IllegalStateException("the program has no models; call Program.models");
        }
        return models.pair();
    }

    /** The clock of the converter and its parts. */
    public Clock clock() {
        Clock known = clock;
        if (known == null) {
            known = closing(new SystemClock());
            clock = known;
        }
        return known;
    }

    /** The converter, to add monitors, execute components and other parts to; the program builds it. */
    public SystemEventConverter converter() {
        SystemEventConverter known = converter;
        if (known == null) {
            LoopConfig usual = LoopConfig.defaults(name, clock())
                    .withPressAge(ServiceOptions.of(settings).pressAge());
            known = new SystemEventConverter(loop.apply(usual));
            converter = known;
            belongings.push(known);
        }
        return known;
    }

    /**
     * Uses a converter that has been built elsewhere, with its journal if there is one, in place of {@link
     * #converter}'s.
     */
    public void uses(SystemEventConverter other) {
        converter = other;
        built = true;
    }

    /**
     * Adds the knowledge of the program's models. While the program runs, its user can change the new model to another
     * one, and is offered the machines in its file.
     */
    public void knowledge(Function<ModelPair, ? extends StateKnowledge> of) {
        converter().addKnowledge(of.apply(models()));
        converter().addKnowledgeFactory(of);
        if (others == null && models != null) {
            others = NewModels.offering(models.offered(), ModelFile::machine);
        }
    }

    /** Adds a controller whose events the console's user raises with {@code press EVENT}. */
    public void controller(PushMonitor monitor) {
        converter().addMonitor(monitor);
        command(ConsoleCommand.press(monitor, converter()::controllerEvents));
    }

    /** Lets the converter evolve by other models than those that {@link #knowledge} offers. */
    public void evolvesBy(NewModels offered) {
        others = offered;
    }

    /** Adds a command of the console. */
    public void command(ConsoleCommand command) {
        commands.add(command);
    }

    /** Adds a command of the console; see {@link ConsoleCommand#of}. */
    public void command(String usage, String help, ConsoleCommand.Action action) {
        command(ConsoleCommand.of(usage, help, action));
    }

    /** Shows a picture on the page, beside the models. */
    public void picture(Picture picture) {
        pictures.add(picture);
    }

    /** Changes how Home Assistant shows the converter; called before it is opened, if it is asked for. */
    public void home(Consumer<HomeAssistant> shown) {
        home = shown;
    }

    /**
     * Opens a part, such as the connection to the device, once the converter is built. It is not called if only the
     * options are printed.
     */
    public void onOpen(Opening opening) {
        openings.add(opening);
    }

    /** Closes a part at the program's end, before those that were given earlier. Returns it. */
    public <T extends AutoCloseable> T closing(T part) {
        belongings.push(part);
        return part;
    }

    /** Builds the converter without its journal. */
    void buildOnly() {
        if (!built) {
            converter().build();
            built = true;
        }
    }

    void build() throws IOException, InterruptedException {
        Path journal = ServiceOptions.of(settings).journal();
        if (!built) {
            if (models != null && !models.time().properties().isEmpty()) {
                ProgramModels drawn = models;
                converter()
                        .watch((running, at, nanos) ->
                                running.equals(drawn.pair()) ? new TimeWatch(drawn.time(), running, at, nanos) : null);
            }
            if (journal != null) {
                converter().journal(Journal.in(journal));
            }
            buildOnly();
        }
        for (Opening opening : openings) {
            opening.open();
        }
    }

    int run(Service service) throws IOException {
        Console console = new Console(converter(), System.in, System.out, System.err);
        commands.forEach(console::addCommand);
        console.addCommand(DriftCommand.of(converter()));
        if (others != null) {
            console.evolvesBy(others);
        }
        Page.open(PageOptions.of(settings), console, System.err, pictures);
        MqttOptions.broker(settings).ifPresent(broker -> {
            HomeAssistant shown = new HomeAssistant(console, broker).pictures(ModelPicture::of);
            home.accept(shown);
            shown.open();
            console.onEnd(reason -> shown.close());
        });
        return service.run(console);
    }

    /** Closes all that belongs to the program, the newest first. */
    void close() {
        while (!belongings.isEmpty()) {
            try {
                belongings.pop().close();
            } catch (InterruptedException end) {
                Thread.currentThread().interrupt();
            } catch (Exception failure) {
                LOG.warn("a part of {} cannot be closed: {}", name, failure.getMessage());
            }
        }
    }
}
