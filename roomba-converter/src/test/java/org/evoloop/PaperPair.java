package org.evoloop;

import java.nio.file.Path;
import org.evoloop.evolution.ModelPair;
import org.evoloop.xmi.ModelFile;

/** The project's models, read from their files. */
public final class PaperPair {
    private PaperPair() {}

    public static ModelPair cleaningRobot() {
        ModelFile file = ModelFile.read(Path.of(System.getProperty("evoloop.root"), "models", "cleaning-robot.xml"));
        return new ModelPair(file.pick("original"), file.pick("new"));
    }
}
