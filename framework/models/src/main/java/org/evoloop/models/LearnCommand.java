package org.evoloop.models;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.ZoneId;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.NoSuchElementException;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import org.evoloop.console.Console;
import org.evoloop.converter.PushMonitor;
import org.evoloop.device.Connection;
import org.evoloop.device.DeviceConverter;
import org.evoloop.device.DeviceFile;
import org.evoloop.device.DeviceProgram;
import org.evoloop.device.LearnSection;
import org.evoloop.learn.AnswerLog;
import org.evoloop.learn.ConverterDevice;
import org.evoloop.learn.LearnProgress;
import org.evoloop.learn.LearnRules;
import org.evoloop.learn.LearnSettings;
import org.evoloop.learn.Learned;
import org.evoloop.learn.Learner;
import org.evoloop.learn.LookExecute;
import org.evoloop.learn.OnceAnalyze;
import org.evoloop.learn.WayHome;
import org.evoloop.models.flat.AstahWriter;
import org.evoloop.page.PageOptions;
import org.evoloop.statechart.FlatDrawing;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.ModelException;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.time.Clock;
import org.evoloop.time.SystemClock;
import org.evoloop.xmi.ModelReference;
import org.evoloop.xmi.ModelWriter;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Learns the original model of a device file's device by operating it. */
@Command(
        name = "learn",
        description = "Learns the state machine of a device by operating it, and writes it as a model.",
        footer = {
            "",
            "Exit status: 0 the machine passed its test, 1 something stays open, which is named, 2 wrong usage or input."
        },
        mixinStandardHelpOptions = true)
@SuppressWarnings("NullAway.Init") // picocli sets the fields
final class LearnCommand implements Callable<Integer> {
    private static final String ORIGINAL = "original";

    @Spec
    private CommandSpec spec;

    @Parameters(
            arity = "0..1",
            paramLabel = "FILE.yaml",
            description = "The device file. Its section learn has the rules.")
    private @Nullable Path file;

    @Option(
            names = "--from-journal",
            arity = "1..*",
            paramLabel = "DIR",
            description = "Operates no device: proposes what its converter's journals show, and claims no more.")
    private List<Path> journals = List.of();

    @Option(
            names = "--output",
            required = true,
            paramLabel = "MODEL",
            description = "The model file that is written: .mmd for Mermaid, .scxml, or .xml for Astah's XMI.")
    private Path output;

    @Option(
            names = "--from",
            paramLabel = "MODEL#NAME",
            description =
                    "A model of the device, which is tested instead of learning from nothing; the differences are named.")
    private @Nullable String from;

    @Option(
            names = "--budget",
            paramLabel = "TIME",
            defaultValue = "1 d",
            description = "Ends with the best machine so far after this time (default: ${DEFAULT-VALUE}).")
    private String budget;

    @Option(
            names = "--longest",
            paramLabel = "TIME",
            defaultValue = "60 s",
            description = "How long each state is observed for what the device does by itself (default:"
                    + " ${DEFAULT-VALUE}).")
    private String longest;

    @Option(
            names = "--journal",
            paramLabel = "DIR",
            description = "Keeps all answers there; the next start goes on with them.")
    private @Nullable Path journal;

    @Option(
            names = "--page",
            paramLabel = "[HOST:]PORT",
            description =
                    "Shows in the browser what is known so far, and what the device does (default: nothing listens).")
    private @Nullable String page;

    @Override
    public Integer call() throws IOException {
        String ending = ending();
        if (!journals.isEmpty()) {
            return fromJournals(ending);
        }
        Path described = file;
        if (described == null) {
            throw new IllegalArgumentException(
                    "name a device file, or the journals of its converter by --from-journal");
        }
        LearnSettings settings =
                new LearnSettings(time("--longest", longest), time("--budget", budget), LearnSettings.USUAL.depth());
        DeviceFile device = DeviceFile.read(described, DeviceProgram.options());
        StateMachine declared = from == null ? null : declared(from, device);
        Learned learned = learn(device, settings, declared);
        report(learned);
        if (declared != null) {
            compare(learned, declared, settings);
        }
        if (learned.states().isEmpty()) {
            return 1;
        }
        List<String> lines =
                learned.edges().stream().map(Learned.Arrow::toString).toList();
        Files.writeString(output, written(learned.model(ORIGINAL), lines, ending));
        return learned.isTested() ? 0 : 1;
    }

    private int fromJournals(String ending) throws IOException {
        if (file != null) {
            throw new IllegalArgumentException("with --from-journal no device is operated; leave out " + file);
        }
        JournalLearning learning =
                new JournalLearning(journals, spec.commandLine().getOut());
        StateMachine machine = learning.propose(
                from == null ? null : ModelReference.parse(from).load(), ORIGINAL);
        if (machine == null) {
            return 1;
        }
        Files.writeString(output, written(machine, learning.seen(), ending));
        return learning.isClear() ? 0 : 1;
    }

    private String ending() {
        String name = String.valueOf(output.getFileName());
        String ending = name.substring(name.lastIndexOf('.') + 1);
        if (!name.contains(".") || !List.of("mmd", "scxml", "xml").contains(ending)) {
            throw new IllegalArgumentException(
                    "--output " + output + " has no ending that names a format; use .mmd, .scxml or .xml");
        }
        Path into = output.toAbsolutePath().getParent();
        if (into == null || !Files.isDirectory(into)) {
            throw new IllegalArgumentException(
                    "--output " + output + " is in a folder that does not exist; make " + into + ", or name another");
        }
        return ending;
    }

    private static StateMachine declared(String reference, DeviceFile device) {
        StateMachine model = ModelReference.parse(reference).load();
        Set<String> known =
                model.triggers().stream().map(Event::name).collect(Collectors.toCollection(LinkedHashSet::new));
        if (device.sent().stream().noneMatch(known::contains)) {
            throw new IllegalArgumentException(
                    "--from " + reference + " has none of the events that " + device.name() + " is sent: "
                            + String.join(", ", device.sent().stream().sorted().toList()));
        }
        return model;
    }

    private void compare(Learned learned, StateMachine declared, LearnSettings settings) {
        PrintWriter out = spec.commandLine().getOut();
        List<String> differences = learned.differences(declared, settings.longest());
        differences.forEach(line -> out.println("differs: " + line));
        if (differences.isEmpty()) {
            out.println("as " + from + " declares, as far as it was tried");
        }
        out.flush();
    }

    private static Duration time(String option, String text) {
        try {
            return new Event("tm(" + text + ")")
                    .timeTrigger()
                    .filter(time -> !time.isZero())
                    .orElseThrow();
        } catch (ModelException | NoSuchElementException wrong) {
            throw new IllegalArgumentException(option + " is '" + text
                    + "', which is no duration; write a number and a unit, such as 60 s or 2 h");
        }
    }

    private Learned learn(DeviceFile device, LearnSettings settings, @Nullable StateMachine declared)
            throws IOException {
        LearnSection section = device.learning();
        if (section.home().isEmpty() && section.reset().isEmpty()) {
            throw new IllegalArgumentException(
                    file + " does not say where each try begins, and where the device is left;"
                            + " add it, such as learn: {home: \"Off\", reset: power}");
        }
        for (Connection connection : device.connections()) {
            if (connection.tellsWhileSending()) {
                throw new IllegalArgumentException(file + ": the contacts of '" + connection.name()
                        + "' tell the device's state while an event is still being sent, which cannot be learned yet;"
                        + " draw the original model, and test it with check and by hand");
            }
        }
        PageOptions shown = page == null ? PageOptions.none() : PageOptions.at(page);
        PushMonitor buttons = new PushMonitor("Learner");
        try (Clock clock = new SystemClock();
                AnswerLog log = log(device.name());
                DeviceConverter opened = DeviceConverter.open(
                        device,
                        device.free(LookExecute.LOOK, LookExecute.SEEN),
                        clock,
                        buttons,
                        new OnceAnalyze(),
                        new LookExecute());
                LearnPage progress = new LearnPage(shown, opened.converter(), settings.budget())) {
            LearnRules rules = rules(section);
            WayHome way = new WayHome(section.home(), section.reset(), section.resetIn(), section.homeWithin());
            ConverterDevice port = new ConverterDevice(opened.converter(), buttons, rules, way, section.settle());
            Learner learner = new Learner(
                    port,
                    device.sent().stream().sorted().toList(),
                    rules,
                    settings,
                    clock,
                    declared,
                    log,
                    onTerminal(progress));
            return Interruptible.call(learner::learn);
        }
    }

    private @Nullable AnswerLog log(String device) throws IOException {
        if (journal == null) {
            return null;
        }
        Files.createDirectories(journal);
        return AnswerLog.open(journal.resolve("answers.log"), device);
    }

    private static LearnRules rules(LearnSection section) {
        return new LearnRules(
                section.never(),
                section.neverIn(),
                section.pressesAnHour().orElse(Integer.MAX_VALUE),
                section.stops().entrySet().stream()
                        .map(stop -> new LearnRules.Stop(stop.getKey(), stop.getValue()))
                        .toList(),
                section.hours().isEmpty()
                        ? null
                        : new LearnRules.Hours(
                                section.hours().get(0), section.hours().get(1), ZoneId.systemDefault()));
    }

    private LearnProgress onTerminal(LearnPage progress) {
        PrintWriter err = spec.commandLine().getErr();
        if (!Console.isOnTerminal()) {
            return progress;
        }
        return (soFar, expected) -> {
            progress.at(soFar, expected);
            err.print("\r" + progress.line() + " ");
            err.flush();
        };
    }

    private void report(Learned learned) {
        PrintWriter out = spec.commandLine().getOut();
        learned.edges().forEach(out::println);
        out.println(learned.states().size() + " states, " + learned.words() + " words in "
                + learned.took().toSeconds() + " s, "
                + (learned.open().isEmpty() ? "tested to depth " + learned.depth() : "not tested to the end"));
        if (!learned.open().isEmpty()) {
            out.println("open: " + learned.open());
        }
        learned.remarks().forEach(remark -> out.println("open: " + remark));
        out.flush();
    }

    /** With comments that say how often each transition was seen, where the format has comments. */
    private static String written(StateMachine machine, List<String> seen, String ending) {
        return switch (ending) {
            case "xml" -> AstahWriter.write(machine);
            case "scxml" -> ModelWriter.SCXML.write(FlatDrawing.of(machine));
            default ->
                ModelWriter.MERMAID.write(FlatDrawing.of(machine))
                        + seen.stream().map(line -> "%% " + line + "\n").collect(Collectors.joining());
        };
    }
}
