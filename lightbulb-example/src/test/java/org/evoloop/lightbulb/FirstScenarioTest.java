package org.evoloop.lightbulb;

import java.nio.file.Path;
import org.evoloop.evolution.ModelPair;
import org.evoloop.testkit.ConverterHarness;
import org.evoloop.xmi.ModelFile;
import org.junit.jupiter.api.Test;

/** The first test of a converter, which docs/testing.md shows. */
class FirstScenarioTest {
    private final ModelFile machines = ModelFile.read(Path.of("../models/light-bulb.xml"));
    private final ModelPair models = new ModelPair(machines.pick("original"), machines.pick("new"));
    private final LightBulb lamp = new LightBulb();

    @Test
    void switchedTwiceTheLampGoesOffByItself() {
        ConverterHarness converter =
                ConverterHarness.of(lamp.knowledge(models)).with(lamp.execute()).start();

        converter.press("switch").expect("on", "on");
        converter.press("switch").expect("on", "wait");
        converter.until("off").expect("off", "off");
    }
}
