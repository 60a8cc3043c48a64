package org.evoloop.roomba;

import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import org.evoloop.check.temporal.Property;
import org.evoloop.check.temporal.PropertyWatch;
import org.evoloop.console.NewModels;
import org.evoloop.converter.Evolution;
import org.evoloop.converter.Probation;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.ModelException;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.xmi.ModelReference;
import org.evoloop.xmi.XmiFile;
import org.evoloop.xmi.XmiMachine;
import org.jspecify.annotations.Nullable;

/**
 * Models to which the robot may evolve while it runs, with the properties beside their files.
 *
 * <p>Threading: thread-safe.
 */
final class OtherModels implements NewModels {
    /** How long a choice on the page or in Home Assistant waits. */
    private static final Duration PATIENCE = Duration.ofSeconds(10);

    private final RoombaConverter roomba;
    private final Path file;
    private @Nullable List<String> choices;

    OtherModels(RoombaConverter roomba) {
        this.roomba = roomba;
        this.file = ModelReference.parse(running()).file();
    }

    @Override
    public StateMachine read(String reference) {
        return XmiFile.machine(reference).withName(reference);
    }

    @Override
    public Probation.Watches watches(String reference, ModelPair next) {
        List<Property> properties = roomba.properties().read(next).properties();
        return (table, from) -> watch(new PropertyWatch(properties, table, from));
    }

    private static Probation.Watch watch(PropertyWatch watch) {
        return entry -> {
            List<Property> broken = watch.ended(entry.occurrence(), entry.after(), entry.outcome(), entry.decision());
            return broken.isEmpty()
                    ? ""
                    : entry.occurrence().label() + " breaks "
                            + broken.stream().map(Property::name).collect(Collectors.joining(", "));
        };
    }

    @Override
    public List<String> offered() {
        return choices().stream().map(name -> file + "#" + name).toList();
    }

    /** The new models to which the robot can evolve, by name: those in the file of the initial one, including that. */
    synchronized List<String> choices() {
        List<String> known = choices;
        if (known == null) {
            known = new ArrayList<>();
            for (XmiMachine machine : XmiFile.read(file).machines()) {
                if (fits(file + "#" + machine.name())) {
                    known.add(machine.name());
                }
            }
            choices = known;
        }
        return known;
    }

    private String running() {
        return roomba.models().pair().evolved().name();
    }

    private boolean fits(String reference) {
        try {
            StateMachine original = roomba.models().pair().original();
            // The original model would be an evolution, too, but a useless one.
            return !reference.equals(original.name())
                    && !RobotModels.of(new ModelPair(original, read(reference)))
                            .pair()
                            .evolved()
                            .states()
                            .isEmpty();
        } catch (ModelException unfit) {
            return false;
        }
    }

    /** The running one of the {@link #choices}. */
    String chosen() {
        String reference = running();
        return reference.substring(reference.lastIndexOf('#') + 1);
    }

    /** Evolves to another one of the {@link #choices}. */
    void choose(String name) {
        String reference = file + "#" + name;
        ModelPair next = new ModelPair(roomba.models().pair().original(), read(reference));
        roomba.converter()
                .evolve(Evolution.to(roomba.converter().knowledgeOf(next)).withDeadline(PATIENCE));
    }
}
