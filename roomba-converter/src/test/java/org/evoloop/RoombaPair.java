package org.evoloop;

import java.nio.file.Path;
import org.evoloop.evolution.ModelPair;
import org.evoloop.xmi.ModelFile;

/** The models of a whole Roomba. */
public final class RoombaPair {
    private RoombaPair() {}

    /** The evolution with this name. */
    public static ModelPair of(String evolution) {
        ModelFile file = ModelFile.read(Path.of(System.getProperty("evoloop.root"), "models", "roomba.xml"));
        return new ModelPair(file.pick("original"), file.pick(evolution));
    }
}
