import org.evoloop.testkit.ConverterHarness
import org.junit.jupiter.api.Test

class LampTest {
    @Test
    fun `the lamp goes off after two seconds or gives a warm light`() {
        val converter = ConverterHarness.of(LampKnowledge()).with(LampExecute()).start()

        converter.press("switch").expect("on", "on")
        converter.press("switch").until("off").expect("off", "off")
        converter.press("switch").press("switch").press("switch").expect("on", "warm")
    }
}
