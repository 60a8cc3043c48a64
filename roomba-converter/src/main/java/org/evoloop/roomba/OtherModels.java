package org.evoloop.roomba;

import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import org.evoloop.check.temporal.Property;
import org.evoloop.check.temporal.PropertyWatch;
import org.evoloop.console.NewModels;
import org.evoloop.converter.Probation;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.xmi.ModelFile;
import org.evoloop.xmi.ModelReference;

/**
 * Models to which the robot may evolve at run time, with the property files next to them.
 *
 * <p>Threading: thread-safe.
 */
final class OtherModels implements NewModels {
    private final RoombaConverter roomba;
    private final Path file;

    OtherModels(RoombaConverter roomba) {
        this.roomba = roomba;
        this.file =
                ModelReference.parse(roomba.models().pair().evolved().name()).file();
    }

    @Override
    public StateMachine read(String reference) {
        return ModelFile.machine(reference).withName(reference);
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
        return ModelFile.read(file).references();
    }
}
