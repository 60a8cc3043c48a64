package org.evoloop.device;

import java.nio.file.Path;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.evoloop.check.timing.TimeRules;
import org.evoloop.config.OptionLine;
import org.evoloop.config.Options;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.device.file.DeviceFileException;
import org.evoloop.device.file.Node;
import org.evoloop.device.file.Problems;
import org.evoloop.device.file.Section;
import org.evoloop.evolution.ModelPair;
import org.evoloop.program.ProgramModels;
import org.evoloop.statemachine.Event;
import org.evoloop.testkit.SimulatedDevice;
import org.evoloop.xmi.ModelReference;
import org.jspecify.annotations.Nullable;

/**
 * A converter as a file: its models, how device and controller are connected, and its functions.
 *
 * <p>Reading it opens nothing. All mistakes are found at once; names are checked against the models.
 *
 * <p>Threading: immutable, but for {@link #connections}, which are assembled once.
 *
 * @since 0.1
 */
public final class DeviceFile {
    /** Whatever has one of these keys is a rule, and no short form. */
    private static final Set<String> RULE_KEYS = Set.of(
            "from",
            "values",
            "event",
            "state",
            "line",
            "topic",
            "json",
            "pattern",
            "ranges",
            "steady",
            "contact",
            "entity",
            "attribute",
            "event-type",
            "trigger");

    /** What {@link #readAgain} takes over. */
    private static final Set<String> CHANGEABLE =
            Set.of("models", "functions", "guards", "effects", "scenarios", "learn");

    private final Path path;
    private final Node.Entries root;
    private final String name;
    private final FileModels models;
    private final ModelPair pair;
    private final List<ModelReference> references;
    private final @Nullable Path properties;
    private final Guards guards;
    private final Connections connections;
    private final FileKnowledge.Content knowledge;
    private final List<Scenario> scenarios;
    private final List<OptionLine> options;
    private final LearnSection learning;
    private final HomeSection home;
    private final DaySection day;
    private final @Nullable Connection confirming;

    private DeviceFile(Path path, SectionReader reader, FileModels models, ModelReader read, Connections connections) {
        this.path = path;
        this.root = reader.file.node();
        this.name = models.converter();
        this.models = models;
        this.pair = models.models();
        this.references = read.references();
        this.properties = read.properties();
        this.guards = reader.guards;
        this.connections = connections;
        this.knowledge = reader.content;
        this.scenarios = List.copyOf(reader.scenarios);
        this.options = List.copyOf(reader.options);
        this.learning = reader.learning;
        this.home = reader.home;
        this.day = reader.day;
        this.confirming = reader.confirming;
    }

    /**
     * Reads a file; its models' paths are relative to its folder.
     *
     * @param programOptions those that every program has, which the file may have, too
     * @throws DeviceFileException with all mistakes
     */
    public static DeviceFile read(Path file, Options programOptions) {
        Problems problems = new Problems(file);
        return read(Section.read(file, problems), problems, programOptions);
    }

    static DeviceFile read(Section file, Problems problems, Options programOptions) {
        ModelReader read = ModelReader.read(file, problems);
        String name = file.need("converter").map(Node.Text::value).orElse("");
        FileModels models = new FileModels(name, read.known(), problems);
        Connections connections = Connections.read(file, models);
        SectionReader reader = new SectionReader(file, models, connections);
        reader.read(programOptions);
        models.checkAll(file);
        reader.home.check(models.models());
        problems.throwIfAny();
        return new DeviceFile(problems.file(), reader, models, read, connections);
    }

    /**
     * Reads the file again, for a converter that runs: what has changed in its models, functions, guards and effects acts
     * over the connections of this one, which stay open.
     *
     * @throws DeviceFileException with all mistakes, or with what has changed and cannot be taken over
     */
    DeviceFile readAgain(Options programOptions) {
        DeviceFile next = read(path, programOptions);
        Problems problems = new Problems(path);
        Section now = new Section("", next.root, problems);
        Section before = new Section("", root, new Problems(path));
        Set<Node.Text> keys = new LinkedHashSet<>(now.keys());
        keys.addAll(before.keys());
        for (Node.Text key : keys) {
            if (!CHANGEABLE.contains(key.value()) && !content(now, key).equals(content(before, key))) {
                problems.at(
                        key,
                        "'" + key + "' has changed, which a running converter cannot take over; restart it, or undo"
                                + " that change");
            }
        }
        problems.throwIfAny();
        SectionReader over = new SectionReader(
                now, new FileModels(name, next.references.isEmpty() ? null : next.pair, problems), connections);
        over.functionsAndEffects(day);
        problems.throwIfAny();
        return new DeviceFile(next, over, connections);
    }

    private static String content(Section section, Node.Text key) {
        return section.any(key.value()).map(Node::content).orElse("");
    }

    /** @param over whose functions use {@code opened} */
    private DeviceFile(DeviceFile next, SectionReader over, Connections opened) {
        this.path = next.path;
        this.root = next.root;
        this.name = next.name;
        this.models = next.models;
        this.pair = next.pair;
        this.references = next.references;
        this.properties = next.properties;
        this.guards = over.guards;
        this.connections = opened;
        this.knowledge = over.content;
        this.scenarios = next.scenarios;
        this.options = next.options;
        this.learning = next.learning;
        this.home = next.home;
        this.day = over.day;
        this.confirming = next.confirming;
    }

    /** The converter's name. */
    public String name() {
        return name;
    }

    /** The models; without any in the file, both have one state with a loop for each event. */
    public ModelPair models() {
        return pair;
    }

    /** The file that was read. */
    public Path path() {
        return path;
    }

    /** The original and the new model, each as {@code FILE#NAME}; none if the file has no models. */
    public List<String> references() {
        return references.stream().map(ModelReference::toString).toList();
    }

    /** The models as a program's, with the time requirements of its properties. */
    ProgramModels programModels() {
        if (references.isEmpty()) {
            return new ProgramModels(pair, TimeRules.NONE, List.of());
        }
        ProgramModels read = ProgramModels.of(references.get(0), references.get(1));
        return properties == null
                ? read
                : new ProgramModels(read.pair(), ProgramModels.time(properties, read.pair()), read.offered());
    }

    /** The file of the new model's properties; empty if none is named, and those beside the model count. */
    public Optional<Path> properties() {
        return Optional.ofNullable(properties);
    }

    /** The guards, to be attached before a converter is built. */
    Guards guards() {
        return guards;
    }

    /** The events that the device raises by itself. */
    public Set<Event> devicesOwn() {
        Set<Event> own = new LinkedHashSet<>(pair.original().spontaneous());
        models.allDevicesOwn().forEach(event -> own.add(new Event(event)));
        return own;
    }

    /**
     * A monitor in place of the controls that the file names, such as a console.
     *
     * @param name of the monitor
     */
    public PushMonitor controller(String name) {
        Set<String> pressed = models.allPressed();
        return new PushMonitor(name) {
            @Override
            protected Set<String> controllerEvents() {
                return pressed;
            }
        };
    }

    /** What the file says about learning the device. */
    public LearnSection learning() {
        return learning;
    }

    /** The entities of Home Assistant. */
    public HomeSection home() {
        return home;
    }

    /** When it raises events by itself, and when it is quiet. */
    DaySection day() {
        return day;
    }

    /** The events that are sent to the device. */
    public Set<String> sent() {
        return Set.copyOf(models.allSent());
    }

    /**
     * Models in which nothing is assumed of the device: the states that it reports, or one, each with a loop for every event.
     *
     * @param more further events
     */
    public ModelPair free(String... more) {
        return models.free(more);
    }

    /** The program's options that the file has. */
    public List<OptionLine> options() {
        return options;
    }

    /** The ways to device and controller. */
    public Collection<Connection> connections() {
        return connections.all();
    }

    /** Whether the device is never asked for its state: then a person has to say where it is. */
    boolean isNeverAsked() {
        Section device =
                new Section("", root, new Problems(path)).section("device").orElse(null);
        return (device == null || !device.has("ask"))
                && connections.all().stream().noneMatch(Connection::asksByItself);
    }

    /** The connection that tells what becomes of all that is sent; null if each tells that of its own. */
    @Nullable
    Connection confirming() {
        return confirming;
    }

    /** The knowledge of these models, with the file's functions. */
    public StateKnowledge knowledge(ModelPair of) {
        return new FileKnowledge(of, knowledge);
    }

    /** The file's scenarios. */
    public List<Scenario> scenarios() {
        return scenarios;
    }

    /** A device that behaves like the original model, in place of the connections. */
    public SimulatedDevice simulated() {
        return SimulatedDevice.of(pair.original())
                .sends(models.allSent().toArray(String[]::new))
                .buttons(models.allDevicesOwn().toArray(String[]::new))
                .answersLocate()
                .build();
    }

    /**
     * The rules under {@code key}, such as {@code state}: a list of them, or one, or, for the only connection, a mapping of
     * what it reports to names, which is returned as a rule, too.
     */
    public static List<Section> rules(Section parent, String key) {
        Optional<Node> found = parent.any(key);
        if (found.isPresent()
                && found.get() instanceof Node.Entries pairs
                && !pairs.entries().isEmpty()) {
            Section all = parent.section(key).orElseThrow();
            boolean isRule = all.keys().stream().map(Node.Text::value).anyMatch(RULE_KEYS::contains);
            return List.of(isRule ? all : wrapped(all));
        }
        return parent.listed(key);
    }

    private static Section wrapped(Section pairs) {
        Node.Text values = new Node.Text(pairs.node().line(), "values", true);
        return new Section(
                pairs.name(), new Node.Entries(values.line(), Map.of(values, pairs.node())), pairs.problems());
    }
}
