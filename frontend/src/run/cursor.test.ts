import { beforeEach, describe, expect, it } from 'vitest'
import { Cursor } from './cursor'

let cursor: Cursor
beforeEach(() => {
  cursor = new Cursor()
  cursor.setEnd(10)
})

describe('the cursor', () => {
  it('stays inside the run', () => {
    cursor.seek(12)
    expect(cursor.time).toBe(10)
    cursor.seek(-1)
    expect(cursor.time).toBe(0)
    cursor.seek(Number.NaN)
    expect(cursor.time).toBe(0)
    cursor.seek(8)
    cursor.setEnd(5)
    expect(cursor.time).toBe(5)
  })

  it('plays at its speed and stops at the end', () => {
    cursor.setSpeed(4)
    cursor.play()
    cursor.advance(1)
    expect(cursor.time).toBe(4)
    cursor.advance(10)
    expect([cursor.time, cursor.playing]).toEqual([10, false])
  })

  it('begins again when it is played from the end', () => {
    cursor.seek(10)
    cursor.play()
    expect(cursor.time).toBe(0)
  })

  it('does not play a run without length', () => {
    const idle = new Cursor()
    idle.play()
    expect(idle.playing).toBe(false)
  })

  it('repeats a stretch', () => {
    cursor.setLoop([2, 4])
    cursor.play()
    cursor.advance(3.5)
    expect(cursor.time).toBe(3.5)
    cursor.advance(1)
    expect([cursor.time, cursor.playing]).toEqual([2, true])
  })

  it('has no stretch without length: playing would stand still in it', () => {
    cursor.setLoop([3, 3])
    expect(cursor.loop).toBeNull()
    cursor.setLoop([10, 12])
    expect(cursor.loop).toBeNull()
  })

  it('cuts the stretch where a shorter run ends', () => {
    cursor.setLoop([3, 9])
    cursor.setEnd(6)
    expect(cursor.loop).toEqual([3, 6])
    cursor.setEnd(2)
    expect(cursor.loop).toBeNull()
  })

  it('repeats the whole of the next run after the whole of this one', () => {
    cursor.setLoop([0, 10])
    cursor.setEnd(20)
    expect(cursor.loop).toEqual([0, 20])
  })

  it('tells times and changes apart', () => {
    const heard: string[] = []
    cursor.onTime(time => heard.push(`time ${time}`))
    const stop = cursor.onChange(() => heard.push('change'))
    cursor.seek(1)
    cursor.seek(1)
    cursor.setSpeed(2)
    stop()
    cursor.play()
    expect(heard).toEqual(['time 1', 'change'])
  })
})
