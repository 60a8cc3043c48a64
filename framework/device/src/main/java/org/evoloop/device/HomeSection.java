package org.evoloop.device;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.evoloop.device.file.Node;
import org.evoloop.device.file.Section;
import org.evoloop.evolution.ModelPair;
import org.evoloop.mqtt.home.HomeAssistant;
import org.evoloop.mqtt.home.HomeEntity;
import org.evoloop.mqtt.home.HomeKind;
import org.evoloop.mqtt.home.HomeTable;
import org.evoloop.statemachine.Event;
import org.jspecify.annotations.Nullable;

/**
 * The entities of Home Assistant in a device file.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public final class HomeSection {
    /** Nothing is said. */
    static final HomeSection NONE = new HomeSection(List.of());

    /** Home Assistant makes ids of names, and takes no longer ones than 255 characters. */
    private static final int LONGEST_NAME = 100;

    private final List<Placed> entities;

    private HomeSection(List<Placed> entities) {
        this.entities = List.copyOf(entities);
    }

    /**
     * An entity.
     *
     * @param place in the file
     */
    record Placed(HomeEntity entity, Section place) {
        /** Notes what the entity says and the models do not have. */
        void check(ModelPair models) {
            List<String> all =
                    models.evolved().triggers().stream().map(Event::name).toList();
            HomeTable.of(entity, models, all)
                    .mistakes()
                    .forEach(mistake -> place.problems().at(where(mistake), mistake.text()));
        }

        private Node where(HomeTable.Mistake mistake) {
            Node part = place.any(mistake.key()).orElse(place.node());
            return part instanceof Node.Entries entries
                    ? entries.entries().entrySet().stream()
                            .filter(each -> each.getKey().value().equals(mistake.name())
                                    || each.getValue().content().contains("'" + mistake.name() + "'"))
                            .findFirst()
                            .map(each -> (Node) each.getKey())
                            .orElse(part)
                    : part;
        }
    }

    /**
     * What the commands of an entity do.
     *
     * @param line of the entity in the file, from 1
     * @param name of the entity
     * @param table what each command does in each state
     */
    public record Table(int line, String name, HomeTable table) {}

    /** What each command of each entity does in each state of the new model. */
    public List<Table> tables(ModelPair models, Set<Event> controllerEvents) {
        List<String> events = controllerEvents.stream().map(Event::name).toList();
        return entities.stream()
                .map(each -> new Table(
                        each.place().node().line(),
                        each.entity().toString(),
                        HomeTable.of(each.entity(), models, events)))
                .toList();
    }

    /** Shows the entities. */
    void addTo(HomeAssistant home) {
        entities.forEach(each -> home.entity(each.entity()));
    }

    /** Notes what the entities say and the models do not have. */
    void check(ModelPair models) {
        entities.forEach(each -> each.check(models));
    }

    /** The entity of a name, such as {@code cover}; null if there is none. */
    @Nullable
    HomeEntity named(String name) {
        return entities.stream()
                .map(Placed::entity)
                .filter(entity -> entity.toString().equals(name))
                .findFirst()
                .orElse(null);
    }

    /** The names of the entities. */
    List<String> names() {
        return entities.stream().map(each -> each.entity().toString()).toList();
    }

    /** Reads the section {@code home-assistant}. */
    static HomeSection read(Section home, FileModels models) {
        List<Placed> entities = new ArrayList<>();
        Set<String> names = new HashSet<>();
        for (HomeKind kind : HomeKind.values()) {
            home.listed(kind.word()).forEach(section -> {
                HomeEntity entity = entity(kind, section, models);
                reading(kind, section, models).ifPresent(entity::reading);
                section.done();
                if (!names.add(entity.key())) {
                    section.problem("there is another " + entity + "; give each its own name");
                }
                entities.add(new Placed(entity, section));
            });
        }
        home.done();
        return new HomeSection(entities);
    }

    private static Optional<String> reading(HomeKind kind, Section section, FileModels models) {
        Node.Text reading = section.text("reading").orElse(null);
        if (reading == null) {
            return Optional.empty();
        }
        if (!kind.hasReading()) {
            section.problems().at(reading, "a " + kind.word() + " shows no reading; a cover and a climate do");
            return Optional.empty();
        }
        return Optional.of(models.reading(reading));
    }

    private static HomeEntity entity(HomeKind kind, Section section, FileModels models) {
        HomeEntity entity = HomeEntity.of(kind);
        section.text("name").ifPresent(name -> {
            if (name.value().length() > LONGEST_NAME) {
                section.problems().at(name, "a name has at most " + LONGEST_NAME + " characters");
            }
            entity.name(name.value());
        });
        section.text("class").ifPresent(its -> {
            section.problems().requireOneOf(its, kind.deviceClasses(), "'" + its + "' is no class of a " + kind.word());
            entity.deviceClass(its.value());
        });
        section.pairs("states").forEach((state, as) -> entity.show(state.value(), as.value()));
        section.section("modes").ifPresent(modes -> {
            if (kind.modeWord().isEmpty()) {
                modes.problem("a " + kind.word() + " has no modes; " + withModes() + " have");
            }
            for (Node.Text mode : modes.keys()) {
                if (mode.value().equals(HomeTable.NO_MODE)) {
                    modes.problems()
                            .at(mode, "'" + mode + "' is how Home Assistant calls no mode; call this one otherwise");
                }
                modes.texts(mode.value()).forEach(state -> entity.mode(mode.value(), state.value()));
            }
        });
        section.pairs("commands").forEach((command, state) -> entity.command(command.value(), state.value()));
        section.texts("presses").forEach(event -> entity.presses(event.value()));
        section.texts("may-pass").forEach(state -> entity.mayPass(state.value()));
        section.section("never-in").ifPresent(states -> {
            for (Node.Text state : states.keys()) {
                models.evolvedState(state);
                states.texts(state.value()).forEach(command -> {
                    states.problems()
                            .requireOneOf(command, entity.commandNames(), entity + " has no command '" + command + "'");
                    entity.neverIn(state.value(), command.value());
                });
            }
            states.done();
        });
        boolean needsModes = kind == HomeKind.SELECT || kind == HomeKind.EVENT;
        if (needsModes && entity.modeNames().isEmpty()) {
            section.problem((kind == HomeKind.EVENT ? "an " : "a ") + kind.word()
                    + " needs modes, such as {done: Done}, its " + kind.modeWord() + "s");
        }
        if (kind == HomeKind.BUTTON && !section.has("commands")) {
            section.problem("a button needs commands, {press: STATE}, with the state to which it leads");
        }
        return entity;
    }

    private static String withModes() {
        return Arrays.stream(HomeKind.values())
                .filter(kind -> !kind.modeWord().isEmpty())
                .map(HomeKind::word)
                .sorted()
                .collect(Collectors.joining(", "));
    }
}
