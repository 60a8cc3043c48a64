package org.evoloop.page;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicLong;
import org.evoloop.Alarm;
import org.evoloop.Machines;
import org.evoloop.PaperModels;
import org.evoloop.console.Console;
import org.evoloop.console.ConsoleCommand;
import org.evoloop.console.NewModels;
import org.evoloop.converter.DeviceLink;
import org.evoloop.converter.EventExecute;
import org.evoloop.converter.Evolution;
import org.evoloop.converter.Probation;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.converter.UnknownEffectException;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Step;
import org.evoloop.function.Reading;
import org.evoloop.loop.LoopConfig;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.time.Clock;
import org.evoloop.time.SystemClock;

/** The converter of the paper's cleaning robot, without a robot, and its page. */
final class Shown implements AutoCloseable {
    private final Clock clock;
    final Panel panel = new Panel();
    final SystemEventConverter converter;
    final Console console;
    final Page page;
    final String token;
    final AtomicLong battery = new AtomicLong(93);

    /** Whether the device can be reached, and whether it answers. */
    final AtomicBoolean reached = new AtomicBoolean(true);

    final AtomicBoolean answers = new AtomicBoolean(true);

    Shown() throws IOException {
        this(List.of());
    }

    Shown(List<Picture> pictures) throws IOException {
        this(pictures, new SystemClock());
    }

    Shown(List<Picture> pictures, Clock clock) throws IOException {
        this.clock = clock;
        converter = new SystemEventConverter(LoopConfig.defaults("robot", clock));
        converter.addMonitor(panel);
        converter.addExecute(execute());
        converter.addSpare("Robot2", this::execute);
        converter.addSpare("Panel2", Panel::new);
        converter.addKnowledge(new Robot(PaperModels.cleaningRobot()));
        converter.addKnowledgeFactory(Robot::new);
        converter.watch((models, at, nanos) -> new Alarm("Who arrives has left", "arriveSpot"));
        converter.addLink(new DeviceLink() {
            @Override
            public boolean isUp() {
                return reached.get();
            }

            @Override
            public Optional<Instant> downSince() {
                return reached.get() ? Optional.empty() : Optional.of(Instant.EPOCH);
            }

            @Override
            public String describe() {
                return "nowhere";
            }

            @Override
            public List<Reading> readings() {
                return List.of(Reading.of("battery", battery.get(), "%"), Reading.of("docked", false));
            }
        });
        converter.build();
        console = new Console(converter, InputStream.nullInputStream(), System.out, System.err);
        console.evolvesBy(new Others());
        console.addCommand(
                ConsoleCommand.of("press BUTTON", "presses a button", (words, out) -> panel.press(words.get(0)))
                        .completing(before -> before.isEmpty() ? List.of("Clean", "Spot") : List.of()));
        console.addCommand(ConsoleCommand.of("device EVENT", "is no button", (words, out) -> panel.acts(words.get(0)))
                .completing(before -> List.of("endSpot"))
                .notOffered());
        console.addCommand(ConsoleCommand.of("robot COMMAND [X]", "is no button", (words, out) -> out.println("no")));
        ByteArrayOutputStream printed = new ByteArrayOutputStream();
        page = Page.open(
                PageOptions.at("0"), console, new PrintStream(printed, true, StandardCharsets.UTF_8), pictures);
        token = printed.toString(StandardCharsets.UTF_8).replaceFirst("(?s).*#token=(\\S+).*", "$1");
    }

    /** The buttons, and what the robot does by itself. */
    static final class Panel extends PushMonitor {
        Panel() {
            super("Panel");
        }

        /** Presses a button; if the queue is full, the event is lost. */
        void operate(String event) {
            push(fromController(event));
        }

        void acts(String event) {
            push(fromDevice(event));
        }
    }

    private static final class Robot extends StateKnowledge {
        Robot(ModelPair models) {
            super(models);
        }

        @Override
        protected void registerNewFunctions() {
            function("Move", visit -> visit.progress("driving", List.of(Reading.of("distance", 1.25, "m"))));
            timer("SpotWait", "timeout", Duration.ofSeconds(600));
        }
    }

    /** Begins a shadow. */
    void tryHasty() {
        Others others = new Others();
        ModelPair running = converter.knowledge().models();
        ModelPair hasty = new ModelPair(running.original(), others.read("hasty"));
        converter.shadow(Evolution.to(converter.knowledgeOf(hasty))
                .withProbation(Probation.NONE.watchedBy(others.watches("hasty", hasty))));
    }

    /** Models in which Spot interrupts Move. */
    private static final class Others implements NewModels {
        @Override
        public StateMachine read(String reference) {
            return Machines.machine(
                    "hasty",
                    "Off Clean -> On",
                    "On Spot -> Move",
                    "On Clean -> Clean",
                    "Move arriveSpot -> Spot",
                    "Move Spot -> On",
                    "Spot endSpot -> On",
                    "Clean Clean -> SpotWait",
                    "SpotWait timeout -> On",
                    "SpotWait Clean -> Spot");
        }

        @Override
        public List<String> offered() {
            return List.of("robot.xml#hasty");
        }

        @Override
        public Probation.Watches watches(String reference, ModelPair next) {
            return (table, from) ->
                    entry -> entry.before().evolved().name().equals("Move") ? "Spot breaks 'Who goes arrives'" : "";
        }
    }

    private EventExecute execute() {
        return new EventExecute("Robot") {
            @Override
            protected Set<String> sendableEvents() {
                return Set.of("Clean", "Spot");
            }

            @Override
            protected void send(Step step) throws UnknownEffectException {
                if (!answers.get()) {
                    throw new UnknownEffectException("no answer to " + step.trigger() + " came");
                }
            }
        };
    }

    String address() {
        return "http://127.0.0.1:" + page.port();
    }

    @Override
    public void close() {
        page.close();
        converter.close();
        clock.close();
    }
}
