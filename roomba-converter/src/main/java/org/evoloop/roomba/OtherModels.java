package org.evoloop.roomba;

import org.evoloop.check.temporal.PropertyWatches;
import org.evoloop.console.NewModels;
import org.evoloop.converter.Probation;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.xmi.ModelReference;

/** Models that the robot may evolve to while it runs, with the properties beside their files. */
final class OtherModels implements NewModels {
    @Override
    public StateMachine read(String reference) {
        return ModelReference.parse(reference).load();
    }

    @Override
    public Probation.Watches watches(String reference, ModelPair next) {
        ModelReference models = ModelReference.parse(reference);
        return PropertyWatches.beside(models.file(), models.machine(), next);
    }
}
