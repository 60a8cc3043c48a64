package com.example.lamp;

import org.evoloop.testkit.ConverterHarness;
import org.junit.jupiter.api.Test;

class LampTest {
    @Test
    void theLampGoesOffAfterTwoSecondsOrGivesAWarmLight() {
        ConverterHarness converter =
                ConverterHarness.of(new LampKnowledge()).with(new LampExecute()).start();

        converter.press("switch").expect("on", "on");
        converter.press("switch").until("off").expect("off", "off");
        converter.press("switch").press("switch").press("switch").expect("on", "warm");
    }
}
