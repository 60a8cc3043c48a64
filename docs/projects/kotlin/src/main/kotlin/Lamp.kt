import java.time.Duration
import org.evoloop.converter.EventExecute
import org.evoloop.converter.PushMonitor
import org.evoloop.converter.StateKnowledge
import org.evoloop.converter.SystemEventConverter
import org.evoloop.evolution.ModelPair
import org.evoloop.evolution.Step
import org.evoloop.loop.LoopConfig
import org.evoloop.statemachine.StateMachine
import org.evoloop.time.SystemClock

private val original = StateMachine.named("lamp")
    .initial("off")
    .transition("off", "switch", "on")
    .transition("on", "switch", "off")
    .build()

private val evolved = StateMachine.named("lamp with a second light")
    .initial("off")
    .transition("off", "switch", "on")
    .transition("on", "switch", "wait")
    .transition("wait", "timeout", "off")
    .transition("wait", "switch", "warm")
    .transition("warm", "switch", "off")
    .build()

/** What the new states do. */
class LampKnowledge : StateKnowledge(ModelPair(original, evolved)) {
    override fun registerNewFunctions() {
        timer("wait", "timeout", Duration.ofSeconds(2))
        function("warm") { println("a warm light") }
    }
}

/** Sends events to the lamp. */
class LampExecute : EventExecute() {
    override fun sendableEvents() = setOf("switch")

    override fun send(step: Step) = println("the lamp gets ${step.trigger()}")
}

/** Each line of the standard input operates the switch. */
fun main() {
    val wallSwitch = PushMonitor("WallSwitch")
    SystemClock().use { clock ->
        SystemEventConverter(LoopConfig.defaults("lamp", clock)).use { converter ->
            converter.addMonitor(wallSwitch)
            converter.addExecute(LampExecute())
            converter.addKnowledge(LampKnowledge())
            converter.build()
            converter.start()
            generateSequence(::readLine).forEach {
                try {
                    wallSwitch.press("switch")
                } catch (lost: IllegalStateException) {
                    System.err.println(lost.message)
                }
            }
        }
    }
}
